// Draws small random bugs in the firmware, and runs the suite of tests/firmware against each bug. If the
// suite does not find the bug, runs the library's unit tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/mutate/mutation.h"
#include "tests/museum/library_tests.h"
#include "tests/museum/stage.h"

namespace robosim::museum {

/// Returns all mutations that `robosim mutate` could draw in firmware/: in Robosim's sketches, their library,
/// and all headers that their compiled sources include. File names are relative to the source tree. The
/// mutations are in order of their places.
std::vector<mutate::Mutation> bugs_of_firmware();

struct Attempt {
  enum class Ending {
    found,
    late,        ///< the suite ran for ten minutes, or its program was killed
    survived,    ///< a run on the host differed, and no test failed
    unobserved,  ///< all runs on the host were bit-identical, and no test failed on a chip
    not_compiled,
  };
  mutate::Mutation bug;
  Ending ending = Ending::survived;
  std::string by;       ///< the target and test that found the bug: "host: PidFollower.StartsAtOnce"
  std::string library;  ///< the unit test that finds a bug that is `survived` or `unobserved`; empty = none
};

const char* word(Attempt::Ending ending);

/// Inserts one bug. Runs the suite on each target, and then the library's unit tests, until a test finds the
/// bug. `unchanged` is the suite's result on the host without the bug.
Attempt attempt(Stage& stage, const LibraryTests& library, const mutate::Mutation& bug,
                const std::vector<std::string>& targets, const TestRun& unchanged);

/// Returns the totals, and each bug that no test found.
std::string summary_of(const std::vector<Attempt>& attempts, std::uint64_t seed, std::size_t places,
                       const std::string& targets);

}  // namespace robosim::museum
