// Detects torn reads and writes. A handler writes a number while the main program is between its bytes, and
// so old and new values are mixed. Also detects lost updates: the main program has read a byte, and is about
// to write it back changed (flags |= 2). A handler that writes it in between is undone.
//
// Such a moment is rare. So a finding proves that it is possible, step by step:
//
//   the program accesses two bytes of a number, or writes back a byte, while interrupts are on
//   an enabled interrupt has a handler that would change the number if it ran there
//   that handler did run within 50 µs, and changed it
//   for a number of several bytes, handlers have changed more than one of them in this run
//
// A number's accesses are not examined before a handler has changed it once. Most numbers belong to the main
// program alone, and reporting each access takes time.
//
// A number is not a finding if it is read again until two reads agree. Nor is it if a flag hands it over, or
// with its interrupt masked. Nor is a byte that is written without regard to its old value. Examined are
// global numbers of the sketch and its libraries whose addresses are in its instructions. The core's own are
// not. When tone() writes its counter while the previous tone counts it down, the sketch is not to blame.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/avr/chip.h"
#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class RaceAnalysis {
 public:
  /// The kind of access by the main program.
  enum class AccessKind { reads, writes, writes_back };
  struct Found {
    const Symbol* number = nullptr;
    AccessKind kind = AccessKind::reads;
    std::uint32_t pc = 0;           ///< of the main program, at a later byte; in bytes
    std::uint32_t handler_pc = 0;   ///< where the handler writes
    robosim::avr::Cycle later = 0;  ///< delay of the handler after that moment
  };

  /// Requests visited() through `show` for a place, in bytes, once a handler has changed what is accessed
  /// there.
  RaceAnalysis(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
               std::function<void(std::uint32_t pc)> show);

  /// Called before the instruction there runs.
  void visited(std::uint32_t pc);
  /// Called when the processor has entered a handler, or returned from one.
  void entered(int vector);
  void left();
  const std::optional<Found>& found() const { return found_; }

 private:
  struct Number {
    const Symbol* symbol = nullptr;
    robosim::avr::Address begin = 0;
    std::uint64_t before = 0;   ///< when the handler began
    std::uint64_t changed = 0;  ///< bits that handlers have changed
  };
  /// An access to a later byte of a number, or the write-back of its only byte.
  struct Access {
    std::uint32_t pc = 0;
    std::size_t number = 0;
    AccessKind kind = AccessKind::reads;
  };
  /// An access that a handler may have torn, and the values at that time: examined once a handler has run.
  struct Armed {
    std::size_t access = 0;
    std::uint64_t vectors = 0;  ///< the enabled ones
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
  std::vector<Armed> armed_;      ///< for each number, the last access that could be torn
  std::uint64_t writers_ = 0;     ///< handlers that may write a number; one bit per vector
  int vector_ = 0;                ///< the vector whose handler runs; 0 = none that is examined
  std::optional<Found> found_;
};

}  // namespace robosim::exec::avr
