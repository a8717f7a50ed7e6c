// Records each executed instruction, with its accesses to data memory.
//
// While the log records, the chip runs in single steps and does not skip waiting loops. This makes the run
// slower, but does not change its results.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/avr/board_adapter.h"
#include "sim/exec/avr/watched_chip.h"
#include "sim/mcu/avr/instruction_effects.h"

namespace robosim::exec::avr {

/// Returns an instruction's effects on registers and flags, including the effects of reading flash. The log
/// contains the effects on data memory.
robosim::avr::InstructionEffects effects_of_logged(const robosim::avr::Instruction& instruction,
                                                   const robosim::avr::Cpu& cpu);

class InstructionLog {
 public:
  enum class Touch : std::uint8_t { nothing, load, store, flash };
  struct Entry {
    std::uint32_t pc = 0;       ///< word address
    std::uint32_t began = 0;    ///< start of the instruction, in cycles after InstructionLog::began()
    std::uint16_t address = 0;  ///< lowest accessed address, in data memory or flash
    std::uint16_t sp = 0;       ///< stack pointer before the instruction
    std::uint8_t bytes = 0;
    Touch touch = Touch::nothing;
    bool interrupts : 1 = false;  ///< the chip entered a handler; `pc` is 0
    bool enables : 1 = false;     ///< interrupts are enabled after the instruction
    std::uint8_t changed = 0;     ///< for a store: the bits of the byte at `address` that changed
  };
  static_assert(sizeof(Entry) == 16);

  /// `chip` and `adapter` must outlive all use of the log.
  InstructionLog(WatchedChip& chip, const BoardAdapter& adapter) : chip_(chip), adapter_(adapter) {}

  void begin();
  // Call before() and after() around each step.
  void before();
  void after();

  const std::vector<Entry>& entries() const { return entries_; }
  Cycle began() const { return began_; }
  /// Returns the board's pin that the load at `index` has read, through the ADC or the pin's port. Returns
  /// kNoPin if the load has not read a pin.
  Pin pin_of(std::size_t index) const;

 private:
  struct Looked {
    std::size_t index = 0;
    Pin pin = kNoPin;
  };
  Pin pin_looked_at(const Entry& entry);
  void find_mask();

  WatchedChip& chip_;
  const BoardAdapter& adapter_;
  std::vector<Entry> entries_;
  std::vector<Looked> looked_;  ///< loads that have read a pin, sorted by index
  Cycle began_ = 0;
  Entry next_;
  std::uint8_t byte_before_ = 0;
  Cycle cycle_before_ = 0;
  bool asleep_before_ = false;
  int handlers_before_ = 0;
  /// A read of a whole port. A later instruction shows which of the port's pins is relevant.
  struct Port {
    int number = -1;        ///< the chip's port; -1 = no such read
    std::size_t index = 0;  ///< entry of the load
    std::uint8_t reg = 0;   ///< register that contains the port's value
  };
  Port port_;
};

}  // namespace robosim::exec::avr
