// Generates stateless noise: the n-th sample of a stream is a pure function of the stream's name and n.
// Adding a part, a recorder or a robot therefore does not change another part's noise.
#pragma once

#include <cstdint>
#include <string_view>

namespace robosim {

/// A stream of noise, named by (seed, robot, part, purpose). Copyable; equal names give equal streams.
class NoiseStream {
 public:
  NoiseStream() = default;
  /// Creates the stream with this name. `part` is a name, so reordering a robot file changes nothing.
  NoiseStream(std::uint64_t seed, std::uint32_t robot, std::string_view part, std::string_view purpose);

  /// Returns 64 uniform bits for sample `n` (SplitMix64's finaliser: Steele, Lea & Flood, OOPSLA 2014).
  std::uint64_t bits(std::uint64_t n) const { return mix(key_ + n * 0x9E3779B97F4A7C15u); }

  /// Returns a value uniformly distributed in [0, 1).
  double uniform(std::uint64_t n) const { return static_cast<double>(bits(n) >> 11) * 0x1p-53; }

  /// Returns a value with mean 0 and standard deviation 1, bounded to ±3.47: the standardised sum of four
  /// uniform 16-bit numbers (Irwin–Hall). Exact in double, without libm.
  double gauss(std::uint64_t n) const {
    const std::uint64_t b = bits(n);
    const auto sum = static_cast<double>((b & 0xFFFF) + (b >> 16 & 0xFFFF) + (b >> 32 & 0xFFFF) + (b >> 48));
    return (sum - 131070.0) * kGaussScale;
  }

 private:
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  // 1 / (65536 sqrt(4/12)), the reciprocal of the sum's standard deviation.
  static constexpr double kGaussScale = 1.0 / 37837.22702;

  std::uint64_t key_ = 0;
};

}  // namespace robosim
