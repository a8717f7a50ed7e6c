// The output of `robosim compare`.
#pragma once

#include <string>

#include "sim/campaign/compare/compared.h"

namespace robosim::cli {

std::string compare_text(const campaign::Compared& compared);
/// Formats the comparison as robosim.compare/1, in one line.
std::string compare_json(const campaign::Compared& compared);

}  // namespace robosim::cli
