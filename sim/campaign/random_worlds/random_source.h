// Provides random numbers to code that must not depend on RapidCheck.
#pragma once

#include <functional>

namespace robosim::random_worlds {

/// Returns a number from 0 to `below` − 1.
using RandomSource = std::function<int(int below)>;

}  // namespace robosim::random_worlds
