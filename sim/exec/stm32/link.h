// Defines the data that the chip's peripherals share: the time, the interrupt controller, and the board that
// is connected to the pins.
#pragma once

#include <functional>

#include "hal/board/input_reads.h"
#include "sim/base/snapshot_registry.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/stm32/clock.h"
#include "sim/exec/stm32/nvic.h"

namespace robosim::exec::stm32 {

/// A pin by the chip's numbering: port 0 = A, 1 = B, 2 = C.
struct ChipPin {
  int port = 0;
  int bit = 0;
  bool operator==(const ChipPin&) const = default;
};

/// The causes of resets during a run (RM0008 7.1.1).
enum class Reset { none, software, independent_watchdog, window_watchdog };

/// A set of signals between peripherals, one bit each.
using Signals = std::uint32_t;
/// Returns the signal of an output of timer 1 to 4. Output 0 is the trigger output TRGO; 1 to 4 are the
/// compare events of the channels.
constexpr Signals signal_of(int timer, int output) { return 1u << (5 * (timer - 1) + output); }
constexpr Signals kExti11 = 1u << 20, kExti15 = 1u << 21;

constexpr ChipPin kNoChipPin = {-1, -1};

struct Link {
  ClockedBoard& board;
  Clock clock;
  Nvic nvic{};
  Reset reset_cause = Reset::none;  ///< cause of the pending reset; `none` = no reset is pending
  Signals listened_to = 0;          ///< signals with a listener
  InputReads reads{};               ///< reads by firmware, with the board's pin numbers
  std::function<void(Signals)> signal{};
  std::uint32_t map = 0;  ///< AFIO_MAPR
  /// Peripherals call this function when the set of pins that they watch has changed.
  std::function<void()> watch_changed{};
  /// Adds a read: a pin, InputReads::kAnalog or InputReads::kSeveral.
  void note_read(Pin read) {
    if (!nvic.in_handler()) reads.add(read);
  }
  std::function<bool(ChipPin)> pin_level{};
  /// Peripherals call this function when they begin to drive a pin differently.
  std::function<void(ChipPin)> pin_changed{};
  /// Saves and restores the state of the chip that changes during a run, except the state of the processor.
  SnapshotRegistry snapshots{};
};

/// An interrupt line shared by two peripherals. The line is high while at least one of them sets it high.
class SharedLine {
 public:
  SharedLine(Link& link, robosim::stm32::Irq irq) : nvic_(link.nvic), irq_(irq) {
    link.snapshots.add(state_);
  }
  /// `source` is 0 or 1.
  void set(int source, bool high) {
    state_.high[source] = high;
    nvic_.set_line(irq_, state_.high[0] || state_.high[1]);
  }

 private:
  struct State {
    bool high[2] = {false, false};
  };

  Nvic& nvic_;
  const robosim::stm32::Irq irq_;
  State state_;
};

}  // namespace robosim::exec::stm32
