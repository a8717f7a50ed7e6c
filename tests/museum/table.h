// Writes the result of each bug as the table of docs/explanation/museum.md.
#pragma once

#include <string>
#include <vector>

#include "tests/museum/bug.h"

namespace robosim::museum {

/// Target name for bugs that only the library's unit tests find.
inline constexpr const char* kUnitTests = "unit tests";

struct Result {
  struct Catch {
    std::string target, test;
  };
  const Bug* bug = nullptr;
  std::vector<Catch> catches;  ///< empty: the bug survived
  double seconds = 0.0;        ///< wall time of all tests that ran for this bug
  std::string trouble;         ///< why the bug could not be tried; empty = it was tried

  bool caught() const { return !catches.empty(); }
  bool on_host() const { return caught() && catches[0].target == "host"; }
  bool by_unit_tests() const { return caught() && catches[0].target == kUnitTests; }
};

/// Returns a list such as "host: PidFollower.StartsAtOnce". The same test on two chips is named once.
std::string catches_of(const Result& result);

/// Returns Markdown: a sentence with the totals, the table, and the survivors with the reasons.
std::string table_of(const std::vector<Result>& results, const std::string& targets);

/// Returns the page's text with a new table between the two lines that enclose it. Throws InputError if one
/// of these lines is missing.
std::string with_table(const std::string& text, const std::string& table);

}  // namespace robosim::museum
