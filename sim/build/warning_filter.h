// Selects the gcc warnings that are shown by default: all except warnings about style.
#pragma once

#include <string>
#include <vector>

namespace robosim::build {

/// Removes -Wparentheses and -Wempty-body warnings about correct code from gcc's messages:
///
///   shown      if (x = 1)           if (400 < x < 600)         if (x);
///   removed    a & 0xF8 | 1         a && b || c                if (x) LOG("a");  with a macro that is empty
///
/// Other messages, with their lines of source, stay unchanged.
std::string without_style_warnings(const std::string& messages);

/// Returns the messages that depend on the width of int, each with its lines of source: overflows, and shifts
/// by too many bits.
std::vector<std::string> width_warnings(const std::string& messages);

/// Returns the messages about variables that are used before they have a value, by gcc's optimiser or by its
/// analyser. Skips those about temporary objects, which have no name.
std::vector<std::string> unset_warnings(const std::string& messages);

}  // namespace robosim::build
