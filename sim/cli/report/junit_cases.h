// Test reports in JUnit's XML, as robosim test --junit, ctest --output-junit and GoogleTest write them: the
// cases, and how each ended. A document type is refused.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::cli {

struct JunitCase {
  enum class Ending { passed, failed, skipped };
  std::string group;  ///< of a class: whose sketch it is
  std::string name;
  Ending ending = Ending::passed;
  double time_s = 0.0;
  std::string message = {};                ///< of a failure; may have several lines
  std::optional<double> off_line_mm = {};  ///< of a check of one run: the farthest
  std::string again = {};                  ///< the command that makes the failed run of a check again
  std::string trace_hash = {};             ///< that it comes to
};

/// Throws InputError with file and line.
std::vector<JunitCase> read_junit(std::string_view text, const std::string& file);

/// The page that the harness has kept of the failed run of a test in C++, as its message says; empty if it
/// names none.
std::string kept_page(const std::string& message);

}  // namespace robosim::cli
