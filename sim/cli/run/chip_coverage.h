// Reads how often the lines of a sketch ran on a chip: the file that a runner writes
// (wire::RunRequest::counters).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace robosim::cli {

/// Returns counts by file and line, and removes the file; without one there are no lines.
std::map<std::pair<std::string, int>, double> take_line_counts(const std::filesystem::path& file);

}  // namespace robosim::cli
