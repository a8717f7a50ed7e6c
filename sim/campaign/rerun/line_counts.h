// Reads the line counts of a sketch on a chip from the file that a runner writes
// (wire::RunRequest::counters).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace robosim::campaign {

/// Returns counts by file and line, and removes the file. Returns no counts if there is no file.
std::map<std::pair<std::string, int>, double> take_line_counts(const std::filesystem::path& file);

}  // namespace robosim::campaign
