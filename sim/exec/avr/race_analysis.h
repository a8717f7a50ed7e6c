// Detects torn reads and torn writes. An interrupt handler tears an access if it writes a number between the
// main program's accesses to the number's bytes. The main program then mixes old and new bytes. Also detects
// lost updates. An update such as `flags|=2` reads a byte, changes the value and writes it back. If a handler
// writes the byte between the read and the write, the handler's write is lost.
//
// An interrupt at such a moment is rare, so the analysis does not wait for one. A finding requires four
// facts, which prove that such an interrupt is possible:
//
//   the program accesses two bytes of a number, or writes back a byte, while interrupts are on
//   an enabled interrupt has a handler that would change the number at that point
//   that handler ran within 50 µs after the access, and changed the number
//   for a number of several bytes, handlers have changed at least two of the bytes in this run
//
// Accesses to a number are examined only after a handler has changed the number. Most numbers belong to the
// main program alone, and observing each access takes time.
//
// Not a finding: a number that is read again until two reads agree, or until no handler has run in between; a
// number that a flag guards; a number that is accessed while the interrupt that changes the number is masked;
// a byte that is written independently of its old value.
//
// A number is a variable, a member of an object or an element of an array (sim/exec/avr/race_candidates.h).
// Two accesses can be torn only if both are within one number. Bytes of two variables, members or elements do
// not belong together, nor do the bytes of strings and buffers. If a pointer register contains the address,
// the register's value is looked up when the instruction runs. This covers `this`, references and indices.
//
// Not detected:
//
//   objects on the heap and the stack, unions and bit fields
//   copies byte by byte: by memcpy() or in a loop
//   an access whose instructions use two pointer registers, or are separated by a jump
//   numbers without debug information: avr-gcc before 8 drops some base classes and static local variables
//   when it optimises at link time, but not in an image built with --sanitize
//   numbers of the Arduino core. For example, tone() writes a counter that the previous tone may be
//   decrementing, but the sketch is not at fault
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/race_candidates.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/mcu/avr/chip.h"

namespace robosim::exec::avr {

class RaceAnalysis {
 public:
  struct Found {
    std::string number;  ///< "ticks", "leftWheel.count_" or "ticks[1]"
    std::uint32_t address = 0, size = 0;
    AccessKind kind = AccessKind::reads;
    std::uint32_t pc = 0;           ///< byte address of the main program's access
    std::uint32_t handler_pc = 0;   ///< byte address of the handler's write
    std::string handler;            ///< function called by an Arduino core's handler; "" for the user's ISR
    robosim::avr::Cycle later = 0;  ///< time from the access to the handler's start, in cycles
  };

  /// When a handler changes a number, calls `show` with the byte address of each access that may concern the
  /// number. From then on, visited() must be called at these addresses.
  RaceAnalysis(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
               std::function<void(std::uint32_t pc)> show);

  /// Called before the instruction at byte address `pc` runs.
  void visited(std::uint32_t pc);
  /// Called when the processor has entered or left a handler.
  void entered(int vector);
  void left();
  /// Returns the first few findings: at most one for each number and each access.
  const std::vector<Found>& found() const { return found_; }

 private:
  /// An access that a handler can tear, with the state of the chip at that time. left() examines the access
  /// after a handler has run.
  struct Armed {
    const RaceCandidate* access = nullptr;
    std::size_t number = 0;
    std::uint64_t vectors = 0;  ///< enabled interrupts, one bit per vector
    robosim::avr::Cycle at = 0;
    std::vector<std::uint8_t> data;
    robosim::avr::Cpu::State state;
  };

  /// The code by which a handler would have changed a number. Addresses are in bytes.
  struct Change {
    std::uint32_t pc = 0;                ///< the instruction that changes the number
    std::vector<std::uint32_t> entered;  ///< targets of the jumps and calls before this instruction
  };

  const SharedNumbers::Number& number(std::size_t index) const { return numbers_.all()[index]; }
  bool is_done() const;
  bool may_write_numbers(int vector) const;
  std::optional<std::size_t> number_of(const RaceCandidate& access, std::uint32_t address) const;
  robosim::avr::Cycle soon() const;
  void touch(const RaceCandidate& access);
  std::optional<Change> would_have_changed(const Armed& armed, int vector);
  std::string handler_of(const Change& change) const;
  void note_changes();
  void note_change(std::size_t index);
  bool can_be_torn(std::size_t index) const;
  template <class Wanted>
  void show_if(Wanted wanted) const;
  void examine(const Armed& armed, int vector);
  std::uint64_t value_of(std::size_t index, const std::uint8_t* data) const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const robosim::avr::Chip& chip_;
  const std::function<void(std::uint32_t)> show_;
  const SharedNumbers numbers_;
  /// Sorted by pc; nullopt until a handler changes a number, because finding the accesses takes time.
  std::optional<std::vector<RaceCandidate>> accesses_;
  robosim::avr::Cpu alone_;
  std::vector<std::uint8_t> before_;    ///< data memory up to the last number, when the handler started
  std::vector<std::uint64_t> changed_;  ///< for each number, the bits that handlers have changed in this run
  std::vector<Armed> armed_;            ///< for each number, the last access that a handler can tear
  std::uint64_t writers_ = 0;           ///< handlers that may write a number; one bit per vector
  int vector_ = 0;                      ///< vector of the running handler; 0 = no handler, or not in writers_
  bool shows_groups_ = false, shows_updates_ = false;  ///< show_ was called for accesses through pointers
  std::vector<Found> found_;
};

/// Returns "torn_read", "torn_write" or "lost_update".
const char* check_of(AccessKind kind);
/// Returns a text that describes the possible fault and the source line of the handler.
std::string torn_text(const RaceAnalysis::Found& found, const DebugInfo& debug, std::uint32_t clock_hz);
/// Returns a text that explains how to fix the sketch: "copy it with interrupts off …"
std::string fix_of(AccessKind kind);

}  // namespace robosim::exec::avr
