// Draws small bugs at random over the firmware, and runs the suite of tests/firmware against each. If that
// does not find a bug, runs the library's unit tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/mutate/mutation.h"
#include "tests/museum/library_tests.h"
#include "tests/museum/stage.h"

namespace robosim::museum {

/// Returns all that robosim mutate could draw in firmware/: our sketches and their library, with all headers
/// that their compiled sources include. Files are named relative to the source tree; in the order of their
/// places.
std::vector<mutate::Mutation> bugs_of_firmware();

struct Attempt {
  enum class Ending {
    found,
    late,        ///< the suite took ten minutes, or its program was ended
    survived,    ///< a run on the host was different, and no test minded
    unobserved,  ///< all runs on the host were the same, bit for bit, and no test on a chip minded
    not_compiled,
  };
  mutate::Mutation bug;
  Ending ending = Ending::survived;
  std::string by;       ///< "host: PidFollower.StartsAtOnce"
  std::string library;  ///< of `survived` and `unobserved`: the unit test that finds it; empty = none
};

const char* word(Attempt::Ending ending);

/// Inserts one bug, and runs the targets, and then the library's tests, until one finds it. `unchanged`: what
/// the suite did without it, on the host.
Attempt attempt(Stage& stage, const LibraryTests& library, const mutate::Mutation& bug,
                const std::vector<std::string>& targets, const TestRun& unchanged);

/// Returns the sums, and each bug that no test found.
std::string summary_of(const std::vector<Attempt>& attempts, std::uint64_t seed, std::size_t places,
                       const std::string& targets);

}  // namespace robosim::museum
