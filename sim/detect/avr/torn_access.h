// Detects torn reads, torn writes and lost updates in the flashed sketch. Uses RaceAnalysis, whose header
// explains these terms (sim/exec/avr/race_analysis.h). A finding does not end the run.
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
  std::vector<SimTime> found_at_;  ///< times of RaceAnalysis::found()
};

}  // namespace robosim::detect::avr
