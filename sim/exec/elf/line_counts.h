// Counts how often the lines of a sketch run on a chip. The image's debug information contains the addresses
// where lines begin. The emulator counts how often the instructions at these addresses run.
// docs/howto/coverage.md explains the counts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {

class LineCounts {
 public:
  /// Reads the addresses where lines begin. Without debug information, no address is known.
  explicit LineCounts(const DebugInfo& debug);

  struct Begin {
    std::uint32_t address = 0;
    std::uint64_t count = 0;
  };
  /// Returns the addresses where lines begin, in ascending order, with their counts.
  const std::vector<Begin>& begins() const { return begins_; }

  /// Adds `times` to the count of the instruction at `address`. A line must begin there.
  void ran(std::uint32_t address, std::uint64_t times = 1);

  /// Returns lines "LINE COUNT FILE". A line's count is the count of its most frequent instruction.
  std::string text() const;

 private:
  std::vector<DebugInfo::CodeLine> lines_;
  std::vector<Begin> begins_;
};

}  // namespace robosim::exec
