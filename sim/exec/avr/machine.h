// Combines the emulated chip with its board, its stack observer and its debug port.
#pragma once

#include "sim/exec/avr/board_adapter.h"
#include "sim/exec/avr/stack.h"
#include "sim/exec/avr/watched_chip.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/tx_provenance.h"
#include "sim/exec/elf/loop_marker.h"

namespace robosim::exec::avr {

class DebugPort;
class InstructionLog;

class Machine final : BoardAdapter {
 public:
  /// `loop` marks the rounds of loop(). All times in the chip are measured by the chip's own clock.
  Machine(const Firmware& firmware, const LoopMarks& loop, ClockedBoard& board, SimTime t);
  ~Machine();

  void run_until(SimTime t);
  /// Sets the debug port, which is called before and after instructions run; may be null.
  void set_debug_port(DebugPort* port);
  /// Records each instruction in `log` from now on; null stops recording. `log` must outlive this object.
  void log_into(InstructionLog* log);
  /// Reports to `bytes` each byte that the firmware prints. `bytes` must outlive this object.
  void trace_bytes(TxProvenance& bytes);
  /// Sets millis() to `start` when main() starts.
  void set_clock(SimTime start);
  Resources resources() const;

  /// Returns a byte of data memory for a debugger, without effect on the firmware. For PINx and UDR0, returns
  /// the value that the firmware read last.
  std::uint8_t peek(reg::Address address);
  /// Writes a byte of data memory with the same effects as a write by the firmware.
  void poke(reg::Address address, std::uint8_t value);

  WatchedChip& chip() { return chip_; }
  const WatchedChip& chip() const { return chip_; }
  const Stack& stack() const { return stack_; }
  const BoardAdapter& adapter() const { return *this; }
  using BoardAdapter::clock_map;

  struct State {
    LoopTimer<Cycle> rounds;
    SimTime clock_start = 0;
  };
  /// All state that changes while the chip runs, except the board's state.
  struct Saved {
    State own;
    WatchedChip::Saved chip;
    BoardAdapter::State adapter;
    Stack::State stack;
  };
  Saved save() const { return {state_, chip_.save(), BoardAdapter::save(), stack_.save()}; }
  void restore(const Saved& saved);

  SimTime now() const { return clock_map().time_of(chip_.cycle()); }

 private:
  void was_reset(std::uint8_t flags, Cycle at) override;
  void look_at_heap(Cycle at);
  void await_loop();
  void loop_began();
  void start_clock();
  void write_called();

  const Firmware& firmware_;
  const LoopMarks loop_;
  ClockedBoard& board_;
  WatchedChip chip_;
  Stack stack_;
  robosim::avr::Events::Id look_ = 0;
  State state_;
  DebugPort* debug_port_ = nullptr;
  InstructionLog* log_ = nullptr;
  TxProvenance* tx_provenance_ = nullptr;
};

}  // namespace robosim::exec::avr
