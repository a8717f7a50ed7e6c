// Measures which lines of a sketch ran. For the host, gcc's counters are compiled into the image
// (Request::coverage). A runner returns their values after a run, and gcov maps the values to lines. For a
// chip, the runner itself counts the lines. The result is stored in lcov's format.
//
//   Request request{…}; request.coverage = true;
//   const Image image = build(request);
//   …                                             // a run with client::RunRequest::coverage = "counters"
//   const Coverage ran = read_coverage(request, image, read_file("counters"));
//   const Coverage all = add_to_folder("coverage", request, image, ran, "oval, seed 1");
//   print(summary(all));
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/build/sketch.h"

namespace robosim::build {

/// Coverage of one of the sketch's own files. Libraries and the core are not counted.
struct FileCoverage {
  struct Function {
    int line = 0;
    std::uint64_t calls = 0;
    bool operator==(const Function&) const = default;
  };
  std::filesystem::path file;          ///< absolute
  std::map<int, std::uint64_t> lines;  ///< lines with code, and how often each ran
  std::map<std::string, Function> functions;
  bool operator==(const FileCoverage&) const = default;
};

/// Coverage of files, sorted by name.
using Coverage = std::vector<FileCoverage>;

/// Returns the coverage from a runner's `counters`, for an image built by `request`. Throws ToolMissing if
/// gcov is missing, and InputError if the counters belong to another image.
Coverage read_coverage(const Request& request, const Image& image, const std::string& counters);

/// Adds the counts of `more` to `sum`.
void add(Coverage& sum, const Coverage& more);

/// Convert to and from lcov's tracefile format, which genhtml and other tools read. Throws InputError if the
/// text is not in that format.
std::string to_info(const Coverage& coverage);
Coverage parse_info(const std::string& text, const std::filesystem::path& file);

/// Stores a run's coverage as `folder`/runs/….info, under a name made from the sketch and the run's
/// `description`. Therefore a repeated run counts only once. Then writes the sum of all runs in `folder` to
/// `folder`/coverage.info, and returns the sum.
///
/// Runs of an older version of the sketch are removed. Concurrent processes are safe. Throws InputError if
/// the folder cannot be written.
Coverage add_to_folder(const std::filesystem::path& folder, const Request& request, const Image& image,
                       const Coverage& coverage, const std::string& description);

/// Returns one line per file: "37 of 41 lines of MySketch.ino ran; never ran: 12-14, 30".
std::string summary(const Coverage& coverage);

/// Runs `genhtml` (of the package lcov) to make `folder`/html from `folder`/coverage.info. Returns false if
/// genhtml is not installed.
bool make_page(const std::filesystem::path& folder);

}  // namespace robosim::build
