// Draws the numbers of a script that vary with the seed: "2s+-500ms", "12+-2,3", "50%±10%". The numbers are
// drawn before a line is parsed, so that the parser need not handle spreads.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "sim/base/error.h"

namespace robosim::scenario {

/// Returns the position of a line's n-th number in its spread, from -1 to 1.
using Share = std::function<double(std::size_t n)>;

/// Returns whether a word contains a number with a spread.
bool has_spread(const std::string& word);

/// Returns the word with the drawn numbers: "14,3" for "12+-2,3". `first` is the index of the word's first
/// number in the line. The function sets it to the index of the next word's first number. Throws InputError
/// with `place`.
std::string with_shares(const std::string& word, const Share& share, std::size_t& first, const Place& place);

}  // namespace robosim::scenario
