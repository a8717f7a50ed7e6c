// Detects torn reads, torn writes and lost updates in the flashed sketch, without ending the run. Uses
// sim/exec/avr/race_analysis.h. In addition to the cases that RaceAnalysis misses, this detector misses
// numbers that the compiler accesses through a pointer register. The compiler may access a number this way
// only in the flashed image, not in an image with checks.
#pragma once

#include <vector>

#include "sim/detect/avr/chip_detector.h"
#include "sim/exec/avr/race_analysis.h"

namespace robosim::detect::avr {

class TornAccess final : public ChipDetector {
 public:
  explicit TornAccess(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  void entered(int vector, Cycle at) override;
  void left() override;
  std::vector<Detected> found(SimTime) const override;

 private:
  Machine& machine_;
  const DebugInfo& debug_;
  exec::avr::RaceAnalysis race_analysis_;
  SimTime found_at_ = 0;
};

}  // namespace robosim::detect::avr
