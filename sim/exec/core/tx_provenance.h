// When a byte leaves the chip, finds the line of the sketch that printed it. Bytes leave in the order in
// which they were passed to HardwareSerial::write(), although a buffer delays them.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

#include "hal/board/sim_time.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class TxProvenance {
 public:
  /// The linker's name of the function through which all bytes pass: HardwareSerial::write(uint8_t).
  static constexpr const char* kFunction = "_ZN14HardwareSerial5writeEh";

  TxProvenance(SimTime from, SimTime to) : from_(from - kLongestWait), to_(to) {}

  /// Starts at power-on. `printing` returns the line of the sketch that is printing. Its argument is the line
  /// of the previous byte.
  void begin(std::function<SourceLine(const SourceLine&)> printing) {
    state_ = {};
    printing_ = std::move(printing);
  }
  /// Records that the firmware called kFunction at `t`.
  void wrote(std::uint8_t byte, SimTime t) {
    if (t >= from_ && t < to_) state_.last = printing_(state_.last);
    state_.waiting.emplace_back(byte, state_.last);
  }
  /// Returns the line of a byte that leaves the chip. Drops earlier bytes, which never left because the port
  /// was closed.
  SourceLine take(std::uint8_t byte) {
    while (!state_.waiting.empty()) {
      auto [written, line] = std::move(state_.waiting.front());
      state_.waiting.pop_front();
      if (written == byte) return line;
    }
    return {};
  }

  struct State {
    SourceLine last;
    std::deque<std::pair<std::uint8_t, SourceLine>> waiting;
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  static constexpr SimTime kLongestWait = kSecond;  // 64 bytes take that long at 600 baud

  const SimTime from_, to_;
  std::function<SourceLine(const SourceLine&)> printing_;
  State state_;
};

}  // namespace robosim::exec
