// Which line of the sketch printed the byte that leaves the chip: between HardwareSerial::write() and the
// UART is a buffer that keeps the order of bytes.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

#include "hal/board/sim_time.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class WrittenBytes {
 public:
  /// The function through which all bytes pass, as the linker calls it: HardwareSerial::write(uint8_t).
  static constexpr const char* kFunction = "_ZN14HardwareSerial5writeEh";

  WrittenBytes(SimTime from, SimTime to) : from_(from - kLongestWait), to_(to) {}

  /// At power-on. `printing` says which line of the sketch prints now, asked while it does; it may get the
  /// line of the byte before.
  void begin(std::function<SourceLine(const SourceLine&)> printing) {
    waiting_.clear();
    last_ = {};
    printing_ = std::move(printing);
  }
  /// The firmware has called kFunction at `t`.
  void wrote(std::uint8_t byte, SimTime t) {
    if (t >= from_ && t < to_) last_ = printing_(last_);
    waiting_.emplace_back(byte, last_);
  }
  /// The line of a byte that leaves. Those before it that never left (the port was closed) are dropped.
  SourceLine take(std::uint8_t byte) {
    while (!waiting_.empty()) {
      auto [written, line] = std::move(waiting_.front());
      waiting_.pop_front();
      if (written == byte) return line;
    }
    return {};
  }

 private:
  static constexpr SimTime kLongestWait = kSecond;  // 64 bytes at 600 baud

  SimTime from_, to_;
  std::function<SourceLine(const SourceLine&)> printing_;
  SourceLine last_;
  std::deque<std::pair<std::uint8_t, SourceLine>> waiting_;
};

}  // namespace robosim::exec
