// Figures of a script that each seed draws anew: "2s+-500ms", "12+-2,3", "50%±10%". They are drawn before a
// line is read, so that nothing behind here knows of them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "sim/base/error.h"

namespace robosim::scenario {

/// Where in its spread a line's n-th figure lies, from -1 to 1.
using Share = std::function<double(std::size_t n)>;

/// Whether a word has a figure with a spread.
bool has_spread(const std::string& word);

/// The word with what its figures are then: "14,3" of "12+-2,3". `first`: the number of its first figure,
/// which becomes that of the next word's. Throws InputError, at `place`.
std::string with_shares(const std::string& word, const Share& share, std::size_t& first, const Place& place);

}  // namespace robosim::scenario
