// Records the instructions that have run, one by one, with their accesses to data memory.
//
// The chip runs single steps meanwhile, and skips no waiting loops; the results are the same.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/avr/instruction_effects.h"
#include "sim/exec/avr/board_adapter.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Returns effects on registers and flags, including those of reading flash. The log has the effects on data
/// memory.
robosim::avr::InstructionEffects effects_of_logged(const robosim::avr::Instruction& instruction,
                                                   const robosim::avr::Cpu& cpu);

class InstructionLog {
 public:
  enum class Touch : std::uint8_t { nothing, load, store, flash };
  struct Entry {
    std::uint32_t pc = 0;       ///< in words
    std::uint32_t began = 0;    ///< cycles after began()
    std::uint16_t address = 0;  ///< in data memory, or in flash, the lowest of `bytes`
    std::uint16_t sp = 0;       ///< before it
    std::uint8_t bytes = 0;
    Touch touch = Touch::nothing;
    bool interrupts : 1 = false;  ///< the jump to a handler; `pc` is 0
    bool enables : 1 = false;     ///< interrupts may come after it
    std::uint8_t changed = 0;     ///< changed bits of the byte at `address`
  };
  static_assert(sizeof(Entry) == 16);

  /// Both outlive its use.
  InstructionLog(WatchedChip& chip, const BoardAdapter& adapter) : chip_(chip), adapter_(adapter) {}

  void begin();
  // Call before() and after() around each step.
  void before();
  void after();

  const std::vector<Entry>& entries() const { return entries_; }
  Cycle began() const { return began_; }
  /// Returns the board's pin that the load `index` has read, by the converter or its port; kNoPin = none.
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
  std::vector<Looked> looked_;  ///< in the order of entries
  Cycle began_ = 0;
  Entry next_;
  std::uint8_t byte_before_ = 0;
  Cycle cycle_before_ = 0;
  bool asleep_before_ = false;
  int handlers_before_ = 0;
  /// A read of a whole port, while the relevant pin is unknown yet.
  struct Port {
    int number = -1;        ///< of the chip; -1 = it is known
    std::size_t index = 0;  ///< of the load
    std::uint8_t reg = 0;   ///< the register that holds it
  };
  Port port_;
};

}  // namespace robosim::exec::avr
