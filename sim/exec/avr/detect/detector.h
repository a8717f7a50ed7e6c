// Who looks on while a sketch runs on the chip as it is flashed, and tells what breaks on a real robot
// (docs/sanitizers.md). The run is the same whether they look or not.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/avr/cycle.h"
#include "sim/exec/avr/firmware.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class Detector {
 public:
  virtual ~Detector() = default;
  /// An instruction is about to run where it has asked for that (WatchedChip::show); in bytes.
  virtual void visited(std::uint32_t pc, robosim::avr::Cycle at) {
    static_cast<void>(pc), static_cast<void>(at);
  }
  /// The processor has entered a handler, or returned from one (WatchedChip::show_handlers).
  virtual void entered(int vector, robosim::avr::Cycle at) {
    static_cast<void>(vector), static_cast<void>(at);
  }
  virtual void left() {}
  virtual std::vector<Detected> found() const = 0;
};

/// What runs on the chip. All outlive their use.
struct Program {
  const Firmware& firmware;
  const DebugInfo& debug;
  const BoardSpec& board;
};

/// Where in the sketch the firmware is now. Costly.
using WhereNow = std::function<SourceLine()>;

/// What a detector has seen, a place each: the first few.
class Sightings {
 public:
  /// One more of the same kind there, or the first.
  void add(Detected seen) {
    for (Detected& known : all_) {
      if (known.detector != seen.detector || known.where.file != seen.where.file ||
          known.where.line != seen.where.line)
        continue;
      known.times += seen.times;
      return;
    }
    if (all_.size() < kMost) all_.push_back(std::move(seen));
  }
  const std::vector<Detected>& all() const { return all_; }

 private:
  static constexpr std::size_t kMost = 8;
  std::vector<Detected> all_;
};

}  // namespace robosim::exec::avr
