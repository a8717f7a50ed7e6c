// Plants small bugs in a sketch, and finds out which ones its checks or tests miss.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/progress.h"
#include "sim/campaign/mutate/mutate_options.h"
#include "sim/campaign/mutate/mutation.h"
#include "sim/campaign/mutate/trial.h"
#include "sim/launch/launch.h"

namespace robosim::mutate {

struct Mutant {
  Mutation mutation;
  Trial trial;
  bool observed = true;  ///< at least one run differs from the unchanged sketch's run
};

struct MutationResult {
  std::string sketch;
  std::string checks;  ///< the file of the checks, or the test programs
  std::string asked;   ///< kind of test: "check" or "test"
  std::uint64_t seed = 1;
  std::size_t places = 0;        ///< number of possible mutations
  std::size_t not_compiled = 0;  ///< number of drawn mutations that do not compile
  std::vector<Mutant> mutants;   ///< in the order of drawing
  std::vector<Mutant> controls;
  bool complete = true;  ///< not interrupted

  std::size_t count(Trial::Ending ending) const;
  std::size_t found() const { return count(Trial::Ending::failed) + count(Trial::Ending::late); }
  std::size_t unobserved() const;
  std::size_t brittle() const;  ///< number of controls (harmless changes) that did not pass
  /// Returns the share of found mutants among all mutants except the unobserved ones. Returns 0 if all are
  /// unobserved, and 1 if there are no mutants.
  double score() const;
};

/// Tests the unchanged sketch, then each bug, then harmless changes. Throws InputError if the unchanged
/// sketch does not pass.
MutationResult plant_bugs(const MutateOptions& options, Progress& progress, const launch::Listener& listener);

}  // namespace robosim::mutate
