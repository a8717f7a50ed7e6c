// Whole files: read, written, hashed; and where Robosim's own files are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim {

/// Opens a file to be read. Throws InputError if it cannot be ("no such file", permissions), and for what is
/// no file: a folder, or a device or a pipe, which may never end.
Descriptor open_to_read(const std::filesystem::path& path);

/// Throws InputError, with the name `path`, for a closed descriptor by errno, and for what is not a file.
void check_is_file(const Descriptor& file, const std::filesystem::path& path);

/// No file that is read as a whole is larger.
inline constexpr std::size_t kMostFile_bytes = std::size_t{256} << 20;

/// The whole content. Throws InputError as open_to_read() does, and if there is more than `most_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes = kMostFile_bytes);

/// Returns the rest of an open file; `path` is its name in messages.
std::string read_file(const Descriptor& file, const std::filesystem::path& path, std::size_t most_bytes);

/// Writes beside the target and renames, so that a reader or an interrupt never sees half a file; a device
/// such as /dev/stdout is written as it is. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Gives a file without a name (O_TMPFILE) that of the target, as write_file() does, but waits for no disk:
/// a power cut in the next seconds may leave an empty file. `error`: what went wrong with it before; 0 =
/// nothing. Throws InputError.
void place_file(const Descriptor& unnamed, const std::filesystem::path& path, int error = 0);

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// The same of a file, read in pieces. Throws InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

/// Where Robosim's own data (hal, firmware, maps, robots) is: beside an installed executable as
/// `../share/robosim`, else the source tree it was built from. A test that links an installed Robosim is told
/// where that is (toolchain/cmake/test_setup.cpp).
std::filesystem::path data_folder();

/// The folder of Robosim's helper executables (runners): beside an installed executable as
/// `../libexec/robosim`, else the build tree's.
std::filesystem::path helper_folder();

}  // namespace robosim
