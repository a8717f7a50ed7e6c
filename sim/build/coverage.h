// Which lines of a sketch ran. For the host the image is compiled with gcc's counters (Request::coverage), a
// runner returns their values after a run, and gcov maps them to lines; of a chip the runner counts, and
// returns lines. The result is kept in lcov's format.
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

/// A file of the sketch's own: libraries and the core are not counted.
struct FileCoverage {
  struct Function {
    int line = 0;
    std::uint64_t calls = 0;
    bool operator==(const Function&) const = default;
  };
  std::filesystem::path file;          ///< absolute
  std::map<int, std::uint64_t> lines;  ///< those with code, and how often each ran
  std::map<std::string, Function> functions;
  bool operator==(const FileCoverage&) const = default;
};

/// Sorted by their names.
using Coverage = std::vector<FileCoverage>;

/// What `counters`, as a runner gives them, say about an image built by `request`. Throws ToolMissing without
/// gcov, InputError if they belong to another image.
Coverage read_coverage(const Request& request, const Image& image, const std::string& counters);

/// Adds `more`, count by count.
void add(Coverage& sum, const Coverage& more);

/// To and from lcov's tracefile format, which genhtml and others read. Throws InputError if the text is not
/// one.
std::string to_info(const Coverage& coverage);
Coverage parse_info(const std::string& text, const std::filesystem::path& file);

/// Keeps a run's coverage as `folder`/runs/….info under a name made of the sketch and of the run's
/// `description`: the same run counts once, however often it is made. Then writes the sum of all runs
/// there to `folder`/coverage.info, and gives it. Runs of an older version of the same sketch are removed.
/// Processes may do that side by side. Throws InputError if the folder cannot be written.
Coverage add_to_folder(const std::filesystem::path& folder, const Request& request, const Image& image,
                       const Coverage& coverage, const std::string& description);

/// A line for each file: "37 of 41 lines of MySketch.ino ran; never: 12-14, 30".
std::string summary(const Coverage& coverage);

/// `genhtml` (of the package lcov) makes `folder`/html from `folder`/coverage.info. False if it is not there.
bool make_page(const std::filesystem::path& folder);

}  // namespace robosim::build
