// Torn reads and writes: the main program is between the bytes of a number when a handler comes that writes
// it, and has half of the old one and half of the new one. And lost updates: the main program has read a byte
// and is about to write it back, changed (flags |= 2), when a handler comes that writes it: that is undone.
//
// Seldom does it come just there. So what is looked for is shown to be possible, step by step:
//
//   the program touches two bytes of a number, or writes back a byte, interrupts being on
//   an interrupt that is enabled has a handler which, run there by itself, would change the number
//   that handler did come, within 50 µs, and changed it
//   of a number of several bytes, handlers have changed more than one in this run
//
// Nobody looks at a number's accesses before a handler has changed it once: most numbers are the program's
// own, and to be told of each access costs time.
//
// A number that is read again until it is the same twice, one that a flag hands over, and one whose interrupt
// is masked meanwhile are none; nor is a byte that is written, and not made of what it held. Looked at are
// global numbers of the sketch and its libraries whose addresses stand in its instructions. The core's own
// are not: that tone() writes its counter while the tone before still counts it down is no fault of a sketch.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/avr/chip.h"
#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class Tearing {
 public:
  /// What the main program does.
  enum class Deed { reads, writes, writes_back };
  struct Found {
    const Symbol* number = nullptr;
    Deed deed = Deed::reads;
    std::uint32_t pc = 0;           ///< of the main program, at a later byte; in bytes
    std::uint32_t handler_pc = 0;   ///< where the handler writes
    robosim::avr::Cycle later = 0;  ///< by how much the handler came too late
  };

  /// Asks by `show` for visited() at a place, in bytes, once a handler has changed what is touched there.
  Tearing(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
          std::function<void(std::uint32_t pc)> show);

  /// The instruction there is about to run.
  void visited(std::uint32_t pc);
  /// The processor has entered a handler, or returned from one.
  void entered(int vector);
  void left();
  const std::optional<Found>& found() const { return found_; }

 private:
  struct Number {
    const Symbol* symbol = nullptr;
    robosim::avr::Address begin = 0;
    std::uint64_t before = 0;   ///< when the handler began
    std::uint64_t changed = 0;  ///< bits that handlers have
  };
  /// A later byte of a number is touched, or its only one written back.
  struct Access {
    std::uint32_t pc = 0;
    std::size_t number = 0;
    Deed deed = Deed::reads;
  };
  /// An access that a handler may have torn, and what held there: to be looked at once one has come.
  struct Armed {
    std::size_t access = 0;
    std::uint64_t vectors = 0;  ///< that are enabled
    robosim::avr::Cycle at = 0;
    std::vector<std::uint8_t> data;
    robosim::avr::Cpu::State state;
  };

  void find_accesses(const DebugInfo& debug);
  void keep_accessed_numbers();
  bool may_write_numbers(int vector) const;
  void add_group(std::uint32_t pc, const DebugInfo& debug);
  void add_update(std::uint32_t pc, const DebugInfo& debug);
  std::optional<std::size_t> touched(const robosim::avr::Instruction& i) const;
  bool is_read_again(std::uint32_t pc, std::size_t number) const;
  robosim::avr::Cycle soon() const;
  void touch(std::size_t access);
  std::optional<std::uint32_t> would_have_changed(const Armed& armed, int vector);
  void note_change(std::size_t number);
  std::uint64_t value_of(const Number& number, const std::vector<std::uint8_t>& data) const;

  const Firmware& firmware_;
  const robosim::avr::Chip& chip_;
  const std::function<void(std::uint32_t)> show_;
  robosim::avr::Cpu alone_;
  std::vector<Number> numbers_;
  std::vector<Access> accesses_;  ///< by pc
  std::vector<Armed> armed_;      ///< the last access to each number that could be torn
  std::uint64_t writers_ = 0;     ///< handlers that may write a number; a bit a vector
  int vector_ = 0;                ///< whose handler runs; 0 = none that is looked at
  std::optional<Found> found_;
};

}  // namespace robosim::exec::avr
