// Manages a copy of the firmware. The caller inserts bugs into the copy, and runs the suite of tests/firmware
// against it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/campaign/mutate/mutation.h"
#include "sim/campaign/mutate/test_report.h"

#include "tests/museum/bug.h"

namespace robosim::museum {

using mutate::TestRun;

/// Selects the target and the test suites to run.
struct Choice {
  std::string target;              ///< "host", "avr", "stm32"
  std::vector<std::string> words;  ///< only suites with one of these words in their names; empty = all
  bool others = false;             ///< inverts `words`: only suites with none of them
};

/// A folder with the layout of an installed Robosim. The test program of tests/firmware is copied into the
/// folder, and compiles the sketches there:
///
///   bin/                      the test program
///   libexec/robosim           -> the runners
///   share/robosim             copies of firmware and tests/firmware/sketches, and links to other folders
class Stage {
 public:
  explicit Stage(std::filesystem::path folder);

  /// Restores the firmware from the source tree.
  void restore();
  /// Returns why the patch does not apply to the firmware, or "". Changes nothing.
  std::string complaint(const Bug& bug) const;
  /// Changes the firmware. Throws InputError if the patch does not apply.
  void spoil(const Bug& bug);
  /// Applies edits, which name files relative to the source tree.
  void spoil(const std::vector<mutate::Edit>& edits);

  /// Runs tests until one fails. Throws as mutate::run_tests does.
  TestRun test(const Choice& choice) const;

  /// Returns the stand-in for the source tree: copies and links.
  std::filesystem::path data() const { return folder_ / "share/robosim"; }
  /// Returns a folder for the caller's own files.
  const std::filesystem::path& scratch() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Removes the environment variables that change how the tests of tests/firmware run, and sets a separate
/// cache. A program that inserts bugs calls this at the beginning of main().
void take_environment();

}  // namespace robosim::museum
