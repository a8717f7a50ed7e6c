// Declares the base class of detectors that observe the flashed sketch on an AVR.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/exec/avr/chip_observer.h"
#include "sim/exec/avr/running_program.h"
#include "sim/exec/core/detector.h"
#include "sim/result/detector_names.h"

namespace robosim::detect::avr {

using exec::DebugInfo;
using exec::Detected;
using exec::SourceLine;
using exec::avr::Firmware;
using exec::avr::Machine;
using exec::avr::RunningProgram;
using exec::avr::WatchedChip;
using robosim::avr::Cycle;
namespace reg = robosim::avr::reg;

class ChipDetector : public exec::Detector, public exec::avr::ChipObserver {};

/// Collects the first few findings, one for each detector and source line.
class Sightings {
 public:
  /// Adds a finding. If the same detector already has a finding at the same line, increases the count of that
  /// finding.
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

}  // namespace robosim::detect::avr
