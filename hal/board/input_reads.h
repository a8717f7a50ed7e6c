// Stores which inputs firmware has read last, for a verdict on firmware that waits for an input.
//
// Uses C++14 without the standard library, because firmware images include this header, too.
#pragma once

#include "hal/board/board.h"

namespace robosim {

/// The last eight reads of inputs outside interrupt handlers.
class InputReads {
 public:
  static constexpr Pin kAnalog = 254;   ///< stands for a conversion of an analog input
  static constexpr Pin kSeveral = 253;  ///< stands for a read of several pins of a port

  /// Adds a read of a pin, kAnalog or kSeveral.
  void add(Pin read) { reads_ = reads_ << 8 | read; }
  /// Returns the pin if there were at least two reads, and all read the same single pin; else kNoPin.
  Pin only_pin() const {
    const auto last = static_cast<Pin>(reads_ & 0xFF);
    if (last == kAnalog || last == kSeveral || (reads_ >> 8 & 0xFF) != last) return kNoPin;
    for (uint64_t earlier = reads_ >> 8; earlier != 0; earlier >>= 8)
      if ((earlier & 0xFF) != last && (earlier & 0xFF) != kNoPin) return kNoPin;
    return last;
  }

 private:
  uint64_t reads_ = ~uint64_t{0};  ///< one byte per read, the latest in the lowest byte; kNoPin = none yet
};

}  // namespace robosim
