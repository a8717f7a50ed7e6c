// Selects the warnings of gcc that are shown by default: those that are not a matter of style.
#pragma once

#include <string>

namespace robosim::build {

/// Returns gcc's messages without those of -Wparentheses and -Wempty-body on correct code:
///
///   shown      if (x = 1)           if (400 < x < 600)         if (x);
///   removed    a & 0xF8 | 1         a && b || c                if (x) LOG("a");  with a macro that is empty
///
/// Other messages, with their lines of source, stay unchanged.
std::string without_style_warnings(const std::string& messages);

}  // namespace robosim::build
