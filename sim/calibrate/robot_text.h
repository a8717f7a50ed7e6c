// Figures put into the text of a robot file, which stays its owner's: values of keys that are there are
// exchanged, keys that are not are added behind their table's last, tables that are not (those of its base)
// at the end. All else, comments and layout included, stays as it is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/calibrate/figures.h"

namespace robosim::calibrate {

/// Throws InputError for text that is no TOML, and for tables in which no line can be added ("motors = { …
/// }").
std::string with_figures(std::string_view text, const std::string& file, const std::vector<Figure>& figures);

}  // namespace robosim::calibrate
