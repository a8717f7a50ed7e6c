// Declares the base class of detectors. Detectors observe the flashed sketch on the chip, and report
// behaviour that would fail on a real robot (docs/howto/sanitizers.md). Detectors do not change the run.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/mcu/avr/cycle.h"

namespace robosim::exec::avr {

class Detector {
 public:
  virtual ~Detector() = default;
  /// Called before an instruction runs, for each byte address requested by WatchedChip::show().
  virtual void visited(std::uint32_t pc, robosim::avr::Cycle at) {
    static_cast<void>(pc), static_cast<void>(at);
  }
  /// Called when the processor has entered or left a handler (WatchedChip::show_handlers()).
  virtual void entered(int vector, robosim::avr::Cycle at) {
    static_cast<void>(vector), static_cast<void>(at);
  }
  virtual void left() {}
  virtual std::vector<Detected> found() const = 0;
};

/// The program that runs on the chip. All referenced objects must outlive their use.
struct Program {
  const Firmware& firmware;
  const DebugInfo& debug;
  const BoardSpec& board;
};

/// Returns the current line of the sketch. Calls are expensive.
using WhereNow = std::function<SourceLine()>;

/// Collects the first few findings of a detector, one per source line.
class Sightings {
 public:
  /// Adds a finding. If the same detector already has a finding at that line, increases its count.
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
