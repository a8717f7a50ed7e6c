// How often the lines of a sketch ran on a chip: its image tells at which addresses a line begins, and
// somebody who runs it counts these. docs/coverage.md says what the numbers mean.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {

class LineCounts {
 public:
  /// Of an image without debug information, no lines.
  explicit LineCounts(const DebugInfo& debug);

  struct Begin {
    std::uint32_t address = 0;
    std::uint64_t count = 0;
  };
  /// Where lines begin, rising, and how often the instruction there has run.
  const std::vector<Begin>& begins() const { return begins_; }

  /// The instruction at `address`, where a line begins, has run so many times more.
  void ran(std::uint32_t address, std::uint64_t times = 1);

  /// "LINE COUNT FILE", each line by that of its instructions which ran most often.
  std::string text() const;

 private:
  std::vector<DebugInfo::CodeLine> lines_;
  std::vector<Begin> begins_;
};

}  // namespace robosim::exec
