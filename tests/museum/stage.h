// A copy of our firmware that can be spoiled, and the suite of tests/firmware against it.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/mutate/mutation.h"

#include "tests/museum/bug.h"

namespace robosim::museum {

/// What a part of the suite came to.
struct TestRun {
  int passed = 0, skipped = 0;
  std::string failed;   ///< the first test that failed, "PidFollower.StartsAtOnce"; empty = none
  std::string message;  ///< the first lines of what it said
  std::map<std::string, std::string> traces;  ///< by test: what all its runs did, as one number
};

/// A test had no run: the sketch does not compile, or what the test asks for does not exist.
struct CouldNotRun : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The suite itself failed; it took ten minutes where `late`.
struct SuiteBroke : std::runtime_error {
  SuiteBroke(const std::string& what, bool took_long) : std::runtime_error(what), late(took_long) {}
  bool late;
};

/// Which tests of a target are run.
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
  /// Why the patch does not apply to it; empty if it does. Nothing is changed.
  std::string complaint(const Bug& bug) const;
  /// Changes the firmware. Throws InputError if the patch does not apply.
  void spoil(const Bug& bug);
  /// Likewise, by edits of files that are named relative to the source tree.
  void spoil(const std::vector<mutate::Edit>& edits);

  /// Runs tests until one fails. Throws CouldNotRun or SuiteBroke if none did, but something else.
  TestRun test(const Choice& choice) const;

 private:
  std::filesystem::path data() const { return folder_ / "share/robosim"; }

  std::filesystem::path folder_;
};

}  // namespace robosim::museum
