// The files that `run` is to leave behind.
#pragma once

#include <vector>

#include "sim/base/write_claim.h"
#include "sim/cli/arguments.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// Of --record and --plot. Throws InputError.
record::Recorders recorders_of(const RunArguments& arguments);
/// That nobody else writes these files meanwhile. Throws InputError.
std::vector<WriteClaim> claims_of(const RunArguments& arguments);

}  // namespace robosim::cli
