// Finds the accesses of the main program that an interrupt handler could tear.
// RaceAnalysis examines these accesses while the program runs.
//
// A number is a variable, a member of an object or an element of an array. The debug information contains the
// types and addresses of the numbers in global and static variables. Addresses are in data memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::exec::avr {

/// The numbers of at most 8 bytes in the sketch and its libraries.
class SharedNumbers {
 public:
  struct Number {
    std::uint32_t begin = 0, size = 0;
    const Symbol* variable = nullptr;
    std::string path;  ///< path within the variable: "", ".count_" or "[1]"
  };

  SharedNumbers(const Firmware& firmware, const DebugInfo& debug, std::size_t data_size);

  const std::vector<Number>& all() const { return all_; }
  /// Returns the index of the number that contains the byte at this address.
  std::optional<std::size_t> at(std::uint32_t address) const;
  /// Returns the range of addresses that contains all numbers.
  std::uint32_t begin() const { return begin_; }
  std::uint32_t end() const { return end_; }

 private:
  std::vector<Number> all_;        ///< sorted by address
  std::vector<std::uint16_t> at_;  ///< for each address, the number's index + 1; 0 = no number
  std::uint32_t begin_ = 0, end_ = 0;
};

/// The kind of access by the main program; `writes_back` writes a byte that was read and then changed.
enum class AccessKind { reads, writes, writes_back };

/// An access to a second byte of a number, or the write-back of a number of one byte.
struct RaceCandidate {
  std::uint32_t pc = 0;  ///< byte address of the instruction
  AccessKind kind = AccessKind::reads;
  std::optional<std::size_t> number;  ///< empty if a pointer register contains the address
  /// Addresses of earlier accesses by the same pointer, relative to this access.
  std::vector<int> earlier;
  /// Relative addresses of bytes that a loop accesses before this access. After the access, the loop reads
  /// these bytes to decide whether to repeat. If handlers change these bytes, the loop repeats torn accesses.
  std::vector<int> guards;
};

/// Returns the accesses, sorted by address. Two accesses may belong to one number if no jump separates them.
/// Both addresses must be constants, or both accesses must use the same pointer register. Skips accesses of
/// handlers, accesses with interrupts off, and numbers that are read again until two reads agree.
std::vector<RaceCandidate> find_race_candidates(const Firmware& firmware, const DebugInfo& debug,
                                                const robosim::avr::Cpu& cpu, const SharedNumbers& numbers);

}  // namespace robosim::exec::avr
