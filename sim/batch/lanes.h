// How a batch lays out its numbers: in blocks of kLanes robots, each figure an array over the block. A loop
// over such arrays is what compilers make vector instructions of.
//
// Vectors change no bit: they do the same additions and multiplications, two or four at once. (Fusing both
// into one instruction would; hence -ffp-contract=off, and AVX2 without FMA.)
#pragma once

#include <cstddef>

// A function of loops over lanes: compiled for AVX2 as well, and chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROBOSIM_LANES_FUNCTION __attribute__((target_clones("avx2", "default")))
#else
#define ROBOSIM_LANES_FUNCTION
#endif

namespace robosim::batch {

/// Robots in a block.
constexpr std::size_t kLanes = 8;

/// A figure of each of them.
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
