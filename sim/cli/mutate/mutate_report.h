// The results of `robosim mutate`, as text and as JSON.
#pragma once

#include <string>

#include "sim/campaign/mutate/mutation_run.h"

namespace robosim::cli {

std::string mutation_text(const mutate::MutationResult& result);
/// Formats the result as robosim.mutate/1, see docs/howto/mutation.md.
std::string mutation_json(const mutate::MutationResult& result);

}  // namespace robosim::cli
