// Terminal looks for tests: plain, with colours, and in ASCII.
#pragma once

#include "sim/tui/frame.h"

namespace robosim::tui {

inline constexpr Look kPlain{true, false};  // no colours
inline constexpr Look kColour{true, true};
inline constexpr Look kAscii{false, false};

}  // namespace robosim::tui
