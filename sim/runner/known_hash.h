// SHA-256 of files, cached for the next request.
#pragma once

#include <filesystem>
#include <string>

namespace robosim::runner {

/// Returns sha256_of_file, cached while the file stays the same by identity, size and times. A runner calls
/// it before it forks. Hashing an image of 600 kB takes a quarter of a run of 10 s. Throws InputError.
const std::string& known_sha256(const std::filesystem::path& file);

}  // namespace robosim::runner
