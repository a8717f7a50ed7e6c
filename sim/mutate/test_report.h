// What a program of GoogleTest tests made of a firmware: read from its report.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace robosim::mutate {

struct TestRun {
  int passed = 0, skipped = 0;
  std::string failed;   ///< the first test that failed, "PidFollower.StartsAtOnce"; empty = none
  std::string message;  ///< the first lines of what it said
  std::map<std::string, std::string> traces;  ///< by test that passed: what all its runs did, as one number
};

/// A test had no run: the sketch does not compile, or what the test asks for does not exist.
struct CouldNotRun : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The program itself failed; its time was up where `late`.
struct ProgramBroke : std::runtime_error {
  ProgramBroke(const std::string& what, bool took_long) : std::runtime_error(what), late(took_long) {}
  bool late;
};

/// Runs a program until its first test fails; `filter` is GoogleTest's; empty = what GTEST_FILTER says.
/// Throws CouldNotRun or ProgramBroke where it was not a test that failed.
TestRun run_tests(const std::filesystem::path& program, const std::string& filter,
                  const std::filesystem::path& scratch, int most_seconds = 600);

}  // namespace robosim::mutate
