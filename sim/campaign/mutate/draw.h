// Draws random choices from a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/base/noise.h"

namespace robosim::mutate {

/// Returns the elements in a random order that depends on the seed. The first n elements are a random sample.
template <typename T>
std::vector<T> shuffled(std::vector<T> all, std::uint64_t seed, const char* purpose) {
  const NoiseStream draw(seed, 0, "mutate", purpose);
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1], all[static_cast<std::size_t>(draw.bits(i) % i)]);
  return all;
}

}  // namespace robosim::mutate
