// Counts how often the lines of a sketch run on a chip. The image's debug information has the addresses where
// lines begin, and the emulator counts the instructions there. docs/howto/coverage.md explains the numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {

class LineCounts {
 public:
  /// Reads the addresses where lines begin. An image without debug information has none.
  explicit LineCounts(const DebugInfo& debug);

  struct Begin {
    std::uint32_t address = 0;
    std::uint64_t count = 0;
  };
  /// Returns the addresses where lines begin, in ascending order, with the number of runs of each.
  const std::vector<Begin>& begins() const { return begins_; }

  /// Adds `times` runs of the instruction at `address`, where a line begins.
  void ran(std::uint32_t address, std::uint64_t times = 1);

  /// Returns lines "LINE COUNT FILE". A line's count is the count of its most frequent instruction.
  std::string text() const;

 private:
  std::vector<DebugInfo::CodeLine> lines_;
  std::vector<Begin> begins_;
};

}  // namespace robosim::exec
