// How often loop() is called, and how long that takes.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robosim::exec {

/// `Time`: a whole number, in whatever unit the chip's clock has.
template <typename Time>
class RoundCounter {
 public:
  /// The next round is the first: there was none before it.
  void await() { running_ = false; }
  bool is_running() const { return running_; }
  /// A round begins, and so ends the one before.
  void began(Time at) {
    if (running_) add(at - began_, 1);
    running_ = true;
    began_ = at;
  }
  /// Rounds began at `first` and then every `period`.
  void began(Time first, Time period, std::uint64_t rounds) {
    began(first);
    if (rounds == 1) return;
    add(period, rounds - 1);
    began_ += static_cast<Time>(rounds - 1) * period;
  }
  /// Rounds of which none was longer than those before; the last one began at `at`.
  void went_on(Time at, std::uint64_t rounds) {
    count_ += rounds;
    total_ += at - began_;
    began_ = at;
  }

  /// From one beginning to the next.
  std::uint64_t count() const { return count_; }
  Time total() const { return total_; }
  /// The one that runs at `now` included.
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
