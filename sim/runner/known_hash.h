// SHA-256 of files, remembered for the next request.
#pragma once

#include <filesystem>
#include <string>

namespace robosim::runner {

/// As sha256_of_file, but remembered while the file stays the same by identity, size and times. A runner asks
/// before it forks: hashing an image of 600 kB would take a quarter of a run of 10 s. Throws InputError.
const std::string& known_sha256(const std::filesystem::path& file);

}  // namespace robosim::runner
