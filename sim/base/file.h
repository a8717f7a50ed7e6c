// Reads, writes and hashes whole files, and finds the folders of Robosim's own files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim {

/// Opens a file for reading. Throws InputError if opening fails ("no such file", permissions). Also throws
/// for a folder, and for a device or pipe, which may never end.
Descriptor open_to_read(const std::filesystem::path& path);

/// Throws InputError for a closed descriptor (with errno), and for anything except a regular file. `path` is
/// the name in messages.
void check_is_file(const Descriptor& file, const std::filesystem::path& path);

/// Size of the largest file that is read as a whole.
inline constexpr std::size_t kMostFile_bytes = std::size_t{256} << 20;

/// Returns the whole content of a file. Throws InputError like open_to_read(), and for more than
/// `most_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes = kMostFile_bytes);

/// Returns the rest of an open file; `path` is its name in messages.
std::string read_file(const Descriptor& file, const std::filesystem::path& path, std::size_t most_bytes);

/// Writes to a temporary file next to the target and renames it. Readers never find half a file, even if
/// writing is interrupted. A device such as /dev/stdout is written directly. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Gives an unnamed file (O_TMPFILE) the name `path`, in one step like write_file(), without waiting for the
/// disk. A power failure in the next seconds may leave an empty file. `error` is the errno of an earlier
/// failure; 0 = none. Throws InputError for this failure, or if the name cannot be given.
void place_file(const Descriptor& unnamed, const std::filesystem::path& path, int error = 0);

/// Returns the SHA-256 hash in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// Returns the hash of a file, which is read in pieces. Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

/// Returns the folder of Robosim's own data (hal, firmware, maps, robots): `../share/robosim` next to an
/// installed executable, otherwise the source tree of the build. A test that links an installed Robosim gets
/// the folder from toolchain/cmake/test_setup.cpp.
const std::filesystem::path& data_folder();

/// Returns the folder of Robosim's helper executables (runners): `../libexec/robosim` next to an installed
/// executable, otherwise a folder of the build tree.
const std::filesystem::path& helper_folder();

}  // namespace robosim
