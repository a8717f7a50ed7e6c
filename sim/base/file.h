// Reads, writes and hashes whole files, and finds Robosim's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim {

/// Opens a file for reading. Throws InputError if that fails ("no such file", permissions), or if the path is
/// a folder, a device or a pipe, which may never end.
Descriptor open_to_read(const std::filesystem::path& path);

/// Throws InputError, with the name `path`, for a closed descriptor (by errno), and for anything but a file.
void check_is_file(const Descriptor& file, const std::filesystem::path& path);

/// The largest file that is read as a whole.
inline constexpr std::size_t kMostFile_bytes = std::size_t{256} << 20;

/// Returns the whole content. Throws InputError as open_to_read() does, and above `most_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes = kMostFile_bytes);

/// Returns the rest of an open file; `path` is its name in messages.
std::string read_file(const Descriptor& file, const std::filesystem::path& path, std::size_t most_bytes);

/// Writes to a temporary file next to the target and renames it, so that readers and interrupts never see
/// half a file. A device such as /dev/stdout is written directly. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Links an unnamed file (O_TMPFILE) to the target's name, as write_file() does, but does not wait for the
/// disk: a power cut in the next seconds may leave an empty file. `error`: errno of an earlier failure; 0 =
/// none. Throws InputError.
void place_file(const Descriptor& unnamed, const std::filesystem::path& path, int error = 0);

/// Returns SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// Hashes a file, read in pieces. Throws InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

/// Returns the folder of Robosim's own data (hal, firmware, maps, robots): `../share/robosim` next to an
/// installed executable, else the source tree of the build. A test that links an installed Robosim gets the
/// folder from toolchain/cmake/test_setup.cpp.
std::filesystem::path data_folder();

/// Returns the folder of Robosim's helper executables (runners): `../libexec/robosim` next to an installed
/// executable, else the build tree's.
std::filesystem::path helper_folder();

}  // namespace robosim
