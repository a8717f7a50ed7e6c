// Defines the layout of numbers in a batch: blocks of kLanes robots, with each value as an array over the
// block. Compilers turn loops over such arrays into vector instructions.
#pragma once

#include <cstddef>

#include "sim/base/function_multiversioning.h"

/// Precedes a function that contains loops over lanes.
#define ROBOSIM_LANES_FUNCTION ROBOSIM_ALSO_FOR("avx2")

namespace robosim::batch {

/// Number of robots in a block.
constexpr std::size_t kLanes = 8;

/// A value for each robot of a block.
struct Lanes {
  alignas(4 * sizeof(double)) double of[kLanes] = {};
  double& operator[](std::size_t lane) { return of[lane]; }
  double operator[](std::size_t lane) const { return of[lane]; }
  static Lanes all(double value) {
    Lanes lanes;
    for (double& each : lanes.of) each = value;
    return lanes;
  }
};

}  // namespace robosim::batch
