// Reads test reports in JUnit's XML, as written by `robosim test --junit`, `ctest --output-junit` and
// GoogleTest: the cases and their results. Rejects a report with a document type.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::campaign {

struct JunitCase {
  enum class Ending { passed, failed, skipped };
  std::string group;  ///< owner of the sketch if the report is on a school class; otherwise the test suite
  std::string name;
  Ending ending = Ending::passed;
  double time_s = 0.0;
  std::string message = {};                ///< message of a failure; may contain several lines
  std::optional<double> off_line_mm = {};  ///< for a check of one run: the largest cross-track error
  std::optional<double> best_lap_s = {};   ///< for a check on a loop: the shortest lap
  std::string again = {};                  ///< the command that repeats the failed run of a check
  std::string trace_hash = {};             ///< the trace hash of the failed run
};

/// Reads the cases. Throws InputError with file and line.
std::vector<JunitCase> read_junit(std::string_view text, const std::string& file);

/// Returns the path of the failed run's page, as named in a C++ test's message; empty if none is named.
std::string kept_page(const std::string& message);

}  // namespace robosim::campaign
