// Defines terminal looks for tests: Unicode without colours, Unicode with colours, and ASCII without colours.
#pragma once

#include "sim/view/terminal/frame.h"

namespace robosim::terminal {

inline constexpr Look kPlain{true, false};  // no colours
inline constexpr Look kColour{true, true};
inline constexpr Look kAscii{false, false};

}  // namespace robosim::terminal
