// The results of `robosim mutate`, as text and as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/mutate/mutation.h"
#include "sim/cli/mutate/trial.h"

namespace robosim::cli {

struct Mutant {
  mutate::Mutation mutation;
  Trial trial;
  bool observed = true;  ///< a run differs from the unchanged sketch's run
};

struct MutationResult {
  std::string sketch;
  std::string checks;  ///< the file of the checks, or the test programs
  std::string asked;   ///< "check" or "test"
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
  /// Returns the share of found mutants among those that a run can show; 1 if there are no such mutants.
  double score() const;
};

std::string mutation_text(const MutationResult& result);
/// Formats the result as robosim.mutate/1, see docs/howto/mutation.md.
std::string mutation_json(const MutationResult& result);

}  // namespace robosim::cli
