// Selects the gcc warnings that are shown by default: all except warnings about style.
#pragma once

#include <string>
#include <vector>

namespace robosim::build {

/// Returns the beginning of a message up to its line: "My.ino:4:" of "My.ino:4:11: warning: ...".
std::string line_of(const std::string& message);

/// Removes -Wparentheses, -Wempty-body and -Wtype-limits warnings about correct code from gcc's messages:
///
///   shown      if (x = 1)           if (400 < x < 600)         if (x);            if (aByte < 0)
///   removed    a & 0xF8 | 1         a && b || c                if (x) LOG("a");   constrain(aByte, 0, 9)
///                                                              with an empty macro
///
/// Reports a variable that hides another one (-Wshadow) only if nothing uses the new variable: the sketch
/// probably meant the other one. Shows only one warning about a statement without effect (-Wunused-value) per
/// line: a macro such as constrain() causes several. Removes warnings that gcc 12 gives without their line;
/// condition_warnings() gives them instead. Other messages, with their lines of source, stay unchanged.
std::string without_style_warnings(const std::string& messages);

/// Returns the messages that depend on the width of int, each with its lines of source: overflows, and shifts
/// by too many bits.
std::vector<std::string> width_warnings(const std::string& messages);

/// Returns the messages of gcc's optimiser and of its analyser about variables that are used before they have
/// a value. Skips those about temporary objects, which have no name.
std::vector<std::string> unset_warnings(const std::string& messages);

}  // namespace robosim::build
