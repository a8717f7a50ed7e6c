// Finds the line of the sketch that printed a byte, at the time when the serial port sends the byte. A buffer
// delays the bytes, but the port sends them in the order in which HardwareSerial::write() received them.
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

  /// Clears the state at power-on. `printing` must return the line of the sketch that is printing. Its
  /// argument is the line of the previous byte.
  void begin(std::function<SourceLine(const SourceLine&)> printing) {
    state_ = {};
    printing_ = std::move(printing);
  }
  /// Records that the firmware called kFunction with `byte` at `t`.
  void wrote(std::uint8_t byte, SimTime t) {
    if (t >= from_ && t < to_) state_.last = printing_(state_.last);
    state_.waiting.emplace_back(byte, state_.last);
  }
  /// Returns the line of a byte that the port is sending. Drops earlier bytes, which were never sent because
  /// the firmware had closed the port.
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
  static constexpr SimTime kLongestWait = kSecond;  // duration of 64 bytes at about 600 baud

  const SimTime from_, to_;
  std::function<SourceLine(const SourceLine&)> printing_;
  State state_;
};

}  // namespace robosim::exec
