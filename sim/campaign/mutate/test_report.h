// Runs a program of GoogleTest tests about a firmware, and reads its report.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace robosim::mutate {

struct TestRun {
  int passed = 0, skipped = 0;
  std::string failed;   ///< the first test that failed, "PidFollower.StartsAtOnce"; empty = none
  std::string message;  ///< the first lines of the failed test's message
  std::map<std::string, std::string> traces;  ///< for each passed test: a fingerprint of its runs
};

/// Thrown if a test could not start a run. Either the sketch does not compile, or the test requests something
/// that does not exist.
struct CouldNotRun : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown if the program itself failed; `late` is true if a timeout stopped it.
struct ProgramBroke : std::runtime_error {
  ProgramBroke(const std::string& what, bool took_long) : std::runtime_error(what), late(took_long) {}
  bool late;
};

/// Runs a program in `folder` until its first test fails. `filter` is GoogleTest's filter; empty =
/// the environment variable GTEST_FILTER. `scratch` receives the report. Throws CouldNotRun,
/// ProgramBroke, and ToolMissing if the program `timeout` is missing.
TestRun run_tests(const std::filesystem::path& program, const std::string& filter,
                  const std::filesystem::path& folder, const std::filesystem::path& scratch,
                  int most_seconds = 600);

}  // namespace robosim::mutate
