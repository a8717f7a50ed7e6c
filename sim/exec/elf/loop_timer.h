// Counts the rounds of loop(), and measures the total time and the longest round.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robosim::exec {

/// `Time` is an integer type: cycles on an AVR, nanoseconds on an STM32.
template <typename Time>
class LoopTimer {
 public:
  /// Discards the running round, for example after a reset. The next round counts as the first round.
  void await() { running_ = false; }
  bool is_running() const { return running_; }
  /// Begins a round at `at`, and ends the previous round.
  void began(Time at) {
    if (running_) add(at - began_, 1);
    running_ = true;
    began_ = at;
  }
  /// Begins `rounds` rounds: the first round at `first`, and each further round one `period` later.
  void began(Time first, Time period, std::uint64_t rounds) {
    began(first);
    if (rounds == 1) return;
    add(period, rounds - 1);
    began_ += static_cast<Time>(rounds - 1) * period;
  }
  /// Begins `rounds` rounds, of which the last round begins at `at`. Must be called only if none of these
  /// rounds is longer than an earlier round.
  void went_on(Time at, std::uint64_t rounds) {
    count_ += rounds;
    total_ += at - began_;
    began_ = at;
  }

  /// Returns the number of completed rounds.
  std::uint64_t count() const { return count_; }
  Time total() const { return total_; }
  /// Returns the duration of the longest round, including the round that is running at `now`.
  Time longest(Time now) const { return std::max(longest_, running_ ? now - began_ : Time{0}); }

 private:
  void add(Time took, std::uint64_t rounds) {
    count_ += rounds;
    total_ += static_cast<Time>(rounds) * took;
    longest_ = std::max(longest_, took);
  }

  bool running_ = false;
  Time began_ = 0, total_ = 0, longest_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace robosim::exec
