// Inserts parameters into the text of a robot file. Values of existing keys are replaced. Missing keys are
// added at the end of their table. Missing tables, which the file inherits from its base, are added at the
// end of the file. Everything else stays, including comments and layout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/campaign/calibrate/figures.h"

namespace robosim::calibrate {

/// Returns the new text. Throws InputError for invalid TOML, and for inline tables ("motors = { … }"), to
/// which no line can be added.
std::string with_figures(std::string_view text, const std::string& file, const std::vector<Figure>& figures);

}  // namespace robosim::calibrate
