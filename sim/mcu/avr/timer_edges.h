// Models the delay of pin edges on their way into a timer (ATmega328P data sheet DS40002061B: 16.6, capture;
// 17.2, external clock).
//
//   pin ─► synchroniser, edge detector: 3 cycles ─► counter, or ICRn
//   pin ─► noise canceler: 4 more cycles; a level shorter than 4 cycles is ignored
//
// A real chip delays an asynchronous edge by 2.5 to 3.5 cycles. An edge that the chip itself causes is
// synchronous with its clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

constexpr Cycle kEdgeCycles = 3, kCancelerCycles = 4;

/// Queues the arrival times of edges that are on their way.
class EdgesUnderWay {
 public:
  Cycle next() const { return count_ ? at_[0] : kNoCycle; }
  void add(Cycle at) {
    if (count_ == at_.size()) return;
    if (count_ && at <= at_[count_ - 1]) at = at_[count_ - 1] + 1;
    at_[count_++] = at;
  }
  void take_first() {
    --count_;
    for (std::size_t i = 0; i < count_; ++i) at_[i] = at_[i + 1];
  }
  void take_last() { --count_; }
  bool any() const { return count_ > 0; }

 private:
  std::array<Cycle, 8> at_{};
  std::uint8_t count_ = 0;
};

/// Filters levels like the noise canceler of ICPn.
class NoiseCanceler {
 public:
  enum class Verdict : std::uint8_t { passes, takes_back };
  /// Switches the canceler on; `level` is the current level of its input.
  void begin(bool level) {
    behind_ = before_ = level;
    since_ = 0;
  }
  /// Handles a level change at the input. Returns takes_back if the change ends a level that was too short.
  /// The caller must then withdraw the edge that began this level.
  Verdict change(bool level, Cycle at) {
    if (at - since_ >= kCancelerCycles) behind_ = before_;
    before_ = level;
    since_ = at;
    return level == behind_ ? Verdict::takes_back : Verdict::passes;
  }

 private:
  bool behind_ = false;  ///< last settled level of the output
  bool before_ = false;  ///< level of the input after its last change
  Cycle since_ = 0;
};

}  // namespace robosim::avr
