// Detects torn reads and torn writes. In a torn access, an interrupt handler writes a number of which the
// main program has accessed only some bytes. The main program then mixes old and new bytes. Also detects lost
// updates: the main program reads a byte, changes the value and writes it back (flags |= 2). If a handler
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
// Not a finding: a number that is read again until two reads agree; a number that a flag guards; a number
// that is accessed while its interrupt is masked; a byte that is written independently of its old value.
//
// The analysis covers global numbers of the sketch and its libraries if instructions contain the numbers'
// addresses. Numbers of the core are excluded. For example, tone() writes a counter that the previous tone
// may be decrementing, but the sketch is not at fault.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/mcu/avr/chip.h"

namespace robosim::exec::avr {

class RaceAnalysis {
 public:
  /// The kind of access by the main program; `writes_back` is the last step of an update.
  enum class AccessKind { reads, writes, writes_back };
  struct Found {
    const Symbol* number = nullptr;
    AccessKind kind = AccessKind::reads;
    std::uint32_t pc = 0;           ///< byte address of the main program's access
    std::uint32_t handler_pc = 0;   ///< byte address of the handler's write
    robosim::avr::Cycle later = 0;  ///< time from the access to the handler's start, in cycles
  };

  /// When a handler first changes a number, calls `show` with the byte address of each access to the number.
  /// From then on, visited() must be called at these addresses.
  RaceAnalysis(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
               std::function<void(std::uint32_t pc)> show);

  /// Called before the instruction at byte address `pc` runs.
  void visited(std::uint32_t pc);
  /// Called when the processor has entered or left a handler.
  void entered(int vector);
  void left();
  const std::optional<Found>& found() const { return found_; }

 private:
  struct Number {
    const Symbol* symbol = nullptr;
    robosim::avr::Address begin = 0;
    std::uint64_t before = 0;   ///< value at the start of the running handler
    std::uint64_t changed = 0;  ///< bits that handlers have changed in this run
  };
  /// An access to the second byte that the program accesses, or the write-back of a number of one byte.
  struct Access {
    std::uint32_t pc = 0;
    std::size_t number = 0;
    AccessKind kind = AccessKind::reads;
  };
  /// An access that a handler can tear, with the state of the chip at that time. left() examines the access
  /// after a handler has run.
  struct Armed {
    std::size_t access = 0;
    std::uint64_t vectors = 0;  ///< enabled interrupts, one bit per vector
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
  std::vector<Access> accesses_;  ///< sorted by pc
  std::vector<Armed> armed_;      ///< for each number, the last access that a handler can tear
  std::uint64_t writers_ = 0;     ///< handlers that may write a number; one bit per vector
  int vector_ = 0;                ///< vector of the running handler; 0 = no handler, or not in writers_
  std::optional<Found> found_;
};

/// Returns "torn_read", "torn_write" or "lost_update".
const char* check_of(RaceAnalysis::AccessKind kind);
/// Returns a text that describes the possible fault and the source line of the handler.
std::string torn_text(const RaceAnalysis::Found& found, const DebugInfo& debug, std::uint32_t clock_hz);
/// Returns a text that says how to fix the sketch: "copy it with interrupts off …"
std::string fix_of(RaceAnalysis::AccessKind kind);

}  // namespace robosim::exec::avr
