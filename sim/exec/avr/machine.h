// The chip with everything around it that firmware can touch.
#pragma once

#include "sim/exec/avr/adc.h"
#include "sim/exec/avr/ports.h"
#include "sim/exec/avr/stack.h"
#include "sim/exec/avr/uart.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/written_bytes.h"

namespace robosim::exec::avr {

class DebugPort;

/// How long sketches take.
struct LoopTimes {
  std::uint64_t count = 0;  ///< passes of loop(), from one beginning to the next
  Cycle longest = 0;
  Cycle total = 0;
};

class Machine final : Peripherals {
 public:
  /// `loop`: the first instruction of loop(), if it is known. Here as everywhere in the chip, times are by
  /// its own clock.
  Machine(const Firmware& firmware, std::optional<std::uint32_t> loop, ClockedBoard& board, SimTime t);
  ~Machine();

  void run_until(SimTime t);
  /// Asked before and after instructions run; may be null.
  void set_debug_port(DebugPort* port);
  /// What the firmware prints is told to `bytes`, which outlives this.
  void trace_bytes(WrittenBytes& bytes);
  /// millis() begins with `start` when main() begins.
  void set_clock(SimTime start);
  Resources resources() const;

  /// Data memory as a debugger sees it, without effect on the firmware: PINx and UDR0 hold what it read last.
  std::uint8_t peek(reg::Address address);
  /// As if the firmware had written there.
  void poke(reg::Address address, std::uint8_t value);

  Chip& chip() { return chip_; }
  const Chip& chip() const { return chip_; }
  const Stack& stack() const { return stack_; }
  const Ports& ports() const { return ports_; }
  const Link& link() const { return link_; }

 private:
  void io_write(reg::Address address, std::uint8_t value) override;
  std::uint8_t io_read(reg::Address address) override;
  void was_reset() override;
  void look() override { stack_.look(); }

  static avr_cycle_count_t on_eeprom_written(avr_t* avr, avr_cycle_count_t when, void* self);
  void write_eeprom_control(std::uint8_t value);
  void timer_written(reg::Address address);
  void take_inputs();
  void loop_began();
  void start_clock();
  void write_called();

  const Firmware& firmware_;
  ClockedBoard& board_;
  Chip chip_;
  Link link_;
  Stack stack_;
  Ports ports_;
  Adc adc_;
  Uart uart_;
  bool eeprom_busy_ = false;
  LoopTimes loop_times_;
  Cycle loop_began_ = 0;
  bool looped_ = false;
  SimTime clock_start_ = 0;
  DebugPort* debug_port_ = nullptr;
  WrittenBytes* written_ = nullptr;
};

}  // namespace robosim::exec::avr
