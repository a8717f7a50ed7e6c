// Whole files: read, written, hashed; and where Robosim's own files are.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace robosim {

/// The whole content. Throws InputError if it cannot be read ("no such file", a folder, permissions).
std::string read_file(const std::filesystem::path& path);

/// Writes beside the target and renames, so that a reader or an interrupt never sees half a file. Throws
/// InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

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
