// Runs the Arduino library's unit tests (tests/unit/nav, tests/unit/firmware) with sanitizers. The tests run
// against a copy of the library in which a bug was inserted (stage.h). An engineer who works on the library
// would also run these tests, after the tests of the sketches.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/museum/stage.h"

namespace robosim::museum {

class LibraryTests {
 public:
  /// Compiles the tests into this folder, against the unchanged library. Throws InputError if a test fails.
  explicit LibraryTests(std::filesystem::path folder);

  /// Recompiles tests that include the changed file (relative to the source tree) against the stage's copy.
  /// Returns the first failure, as "nav_test: Planners.AgreeOnThousandsOfTrees", or how the program ended.
  /// Returns "" if nothing fails, or if the tests do not compile with the change.
  std::string failure(const Stage& stage, const std::string& changed) const;

 private:
  struct Program {
    std::string name;
    std::vector<std::string> sources;  ///< relative to the source tree
  };

  std::filesystem::path object(const std::string& source) const;

  std::filesystem::path folder_;
  std::vector<Program> programs_;
};

}  // namespace robosim::museum
