// Which of gcc's warnings are shown unless more are asked for: those that are no matter of style.
#pragma once

#include <string>

namespace robosim::build {

/// What gcc says with -Wparentheses and -Wempty-body, without what it says of right code:
///
///   shown      if (x = 1)           if (400 < x < 600)         if (x);
///   left out   a & 0xF8 | 1         a && b || c                if (x) LOG("a");  of a macro that is empty
///
/// Other messages, and the lines of source that belong to each, stay as they are.
std::string slips_of(const std::string& messages);

}  // namespace robosim::build
