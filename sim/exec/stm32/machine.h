// Combines the emulated processor with its bus, its board and its debug port.
#pragma once

#include "sim/exec/core/executor.h"
#include "sim/exec/core/tx_provenance.h"
#include "sim/exec/core/watchdog_resets.h"
#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

class DebugPort;

class Machine {
 public:
  /// `loop` marks the rounds of loop(). All times in the chip are measured by the chip's own clock.
  Machine(const Firmware& firmware, const LoopMarks& loop, ClockedBoard& board, FlashMemory& memory,
          Engine& engine, SimTime t);

  void run_until(SimTime t);
  /// Makes millis() count from `start` when main() begins.
  void set_clock(SimTime start);
  /// Reports to `bytes` each byte that the firmware prints. `bytes` must outlive this object.
  void trace_bytes(TxProvenance& bytes);
  /// Sets a function that is called before each store to a peripheral's register.
  void before_stores(std::function<void(Address)> watcher) { bus_.before_stores(std::move(watcher)); }
  Resources resources() const;
  int watchdog_resets() const { return state_.watchdog_resets.count(); }
  /// Returns the calls that have not returned, innermost first. Every word on the stack that points after a
  /// BL or BLX instruction counts as a return address.
  std::vector<std::uint32_t> open_calls() const;

  struct State {
    WatchdogResets watchdog_resets;
  };
  /// All state that changes while the chip runs, except the state of its board and the content of flash.
  struct Saved {
    State own;
    SnapshotRegistry::Snapshot bus;
    Cpu::Saved cpu;
  };
  Saved save() const { return {state_, bus_.save(), cpu_.save()}; }
  void restore(const Saved& saved);

  /// Sets the debug port, which is called before and after instructions run; may be null.
  void set_debug_port(DebugPort* port);

  Cpu& cpu() { return cpu_; }
  const Cpu& cpu() const { return cpu_; }
  const Nvic& nvic() const { return bus_.link().nvic; }
  const Bus& bus() const { return bus_; }
  SimTime time_of(Cycle cycle) const { return bus_.link().clock.time_of(cycle); }

 private:
  void look_at_heap();
  void restart();
  void write_called(TxProvenance& bytes);

  const Firmware& firmware_;
  ClockedBoard& board_;
  Bus bus_;
  Cpu cpu_;
  const std::uint32_t stack_top_;
  Address heap_pointer_ = 0;  ///< address of the variable that stores the heap's end; 0 = unknown
  DebugPort* debug_port_ = nullptr;
  State state_;
};

}  // namespace robosim::exec::stm32
