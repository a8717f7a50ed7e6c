// The chip with everything around it that firmware can touch.
#pragma once

#include "sim/executors/executor.h"
#include "sim/executors/stm32/cpu.h"

namespace robosim::executors::stm32 {

class Machine {
 public:
  /// `loop`: the first instruction of loop(), if it is known.
  Machine(const Firmware& firmware, std::optional<std::uint32_t> loop, BoardState& board, EepromPages& pages,
          SimTime t);

  void run_until(SimTime t);
  /// millis() begins with `start` when main() begins.
  void set_clock(SimTime start);
  Resources resources() const;
  /// The firmware sleeps, and nothing will ever wake it.
  bool is_off() const { return off_; }

  const Cpu& cpu() const { return cpu_; }
  const Bus& bus() const { return bus_; }
  SimTime time_of(Cycle cycle) const { return bus_.link().clock.time_of(cycle); }

 private:
  void look_at_heap();

  const Firmware& firmware_;
  BoardState& board_;
  Bus bus_;
  Cpu cpu_;
  std::uint32_t stack_top_;
  Address heap_pointer_ = 0;  ///< where the heap's end is kept; 0 = unknown
  bool off_ = false;
};

}  // namespace robosim::executors::stm32
