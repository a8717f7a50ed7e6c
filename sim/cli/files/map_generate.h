// `robosim map generate`: generates random maps.
#pragma once

#include <iosfwd>

#include "sim/base/error.h"
#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Writes `count` maps, with seeds seed, seed + 1, …, as FOLDER/FAMILY-SIZE-SEED.map. Writes nothing if
/// any of these files already exists. Throws InputError.
ExitStatus generate_maps(const GenerateArguments& arguments, std::ostream& out);

}  // namespace robosim::cli
