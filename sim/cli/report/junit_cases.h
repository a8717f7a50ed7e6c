// Test reports in JUnit's XML, as robosim test --junit, ctest --output-junit and GoogleTest write them: the
// cases, and how each ended. A document type is refused.
#pragma once

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
  std::string message;  ///< of a failure
};

/// Throws InputError with file and line.
std::vector<JunitCase> read_junit(std::string_view text, const std::string& file);

}  // namespace robosim::cli
