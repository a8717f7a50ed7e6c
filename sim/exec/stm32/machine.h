// The chip with everything around it that firmware can touch.
#pragma once

#include "sim/exec/core/bites.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/written_bytes.h"
#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

class DebugPort;

class Machine {
 public:
  /// `loop`: the rounds of loop(). Here as everywhere in the chip, times are by its own clock.
  Machine(const Firmware& firmware, const Rounds& loop, ClockedBoard& board, FlashMemory& memory,
          Engine& engine, SimTime t);

  void run_until(SimTime t);
  /// millis() begins with `start` when main() begins.
  void set_clock(SimTime start);
  /// What the firmware prints is told to `bytes`, which outlives this.
  void trace_bytes(WrittenBytes& bytes);
  /// Whom to call before each store to a register.
  void before_stores(std::function<void(Address)> watcher) { bus_.before_stores(std::move(watcher)); }
  Resources resources() const;
  /// The calls that are open: words on the stack that are the address behind a BL or BLX, innermost first.
  std::vector<std::uint32_t> open_calls() const;
  /// The firmware sleeps, and nothing will ever wake it.
  bool is_off() const { return state_.off; }

  struct State {
    bool off = false;
    Bites bites;
  };
  /// All that changes while the chip runs, but for its board and what flash holds.
  struct Saved {
    State own;
    Kept::Copy bus;
    Cpu::Saved cpu;
  };
  Saved save() const { return {state_, bus_.save(), cpu_.save()}; }
  void restore(const Saved& saved);

  /// Asked before and after instructions run; may be null.
  void set_debug_port(DebugPort* port);

  Cpu& cpu() { return cpu_; }
  const Cpu& cpu() const { return cpu_; }
  const Nvic& nvic() const { return bus_.link().nvic; }
  const Bus& bus() const { return bus_; }
  SimTime time_of(Cycle cycle) const { return bus_.link().clock.time_of(cycle); }

 private:
  void look_at_heap();
  void restart();
  void write_called(WrittenBytes& bytes);

  const Firmware& firmware_;
  ClockedBoard& board_;
  Bus bus_;
  Cpu cpu_;
  const std::uint32_t stack_top_;
  Address heap_pointer_ = 0;  ///< where the heap's end is kept; 0 = unknown
  DebugPort* debug_port_ = nullptr;
  State state_;
};

}  // namespace robosim::exec::stm32
