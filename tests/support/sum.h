// Computes hashes, with which tests compare runs.
#pragma once

#include <cstdint>

namespace robosim::run {

/// A hash of many numbers.
class Sum {
 public:
  void add(std::uint64_t value) { sum_ = (sum_ ^ value) * 1099511628211u; }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 1469598103934665603u;
};

}  // namespace robosim::run
