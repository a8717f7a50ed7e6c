// A copy of the firmware for inserting bugs, and the suite of tests/firmware against it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/mutate/mutation.h"
#include "sim/mutate/test_report.h"

#include "tests/museum/bug.h"

namespace robosim::museum {

using mutate::TestRun;

/// Selects the tests of a target to run.
struct Choice {
  std::string target;              ///< "host", "avr", "stm32"
  std::vector<std::string> words;  ///< only suites with one of these in their names; empty = all
  bool others = false;             ///< turned round: only suites with none of them
};

/// Laid out as an installed Robosim, so that the test program, copied into it, compiles the sketches in it:
///
///   bin/                      the test program
///   libexec/robosim           -> the runners
///   share/robosim/firmware    a copy, as tests/firmware/sketches is; everything else there is a link
class Stage {
 public:
  explicit Stage(std::filesystem::path folder);

  /// Puts the firmware back as it is in the source tree.
  void restore();
  /// Returns why the patch does not apply to it; empty if it does. Nothing is changed.
  std::string complaint(const Bug& bug) const;
  /// Changes the firmware. Throws InputError if the patch does not apply.
  void spoil(const Bug& bug);
  /// Applies edits of files, which are named relative to the source tree.
  void spoil(const std::vector<mutate::Edit>& edits);

  /// Runs tests until one fails. Throws as mutate::run_tests does.
  TestRun test(const Choice& choice) const;

  /// Returns the stand-in for the source tree: copies and links.
  std::filesystem::path data() const { return folder_ / "share/robosim"; }
  /// For files of one's own.
  const std::filesystem::path& scratch() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// The suite's own switches are ours in a program that spoils firmware, and the cache is one of its own.
/// First of all in its main().
void take_environment();

}  // namespace robosim::museum
