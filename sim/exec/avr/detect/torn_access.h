// Detects torn reads, torn writes and lost updates (detect/race_analysis.h) in the flashed sketch, without
// ending the run. In addition to the cases that RaceAnalysis misses, this detector misses numbers that the
// compiler accesses through a pointer register. The compiler may access a number this way only in the flashed
// image, not in an image with checks.
#pragma once

#include <string>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/detect/race_analysis.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

/// Returns "torn_read", "torn_write" or "lost_update".
const char* check_of(RaceAnalysis::AccessKind kind);
/// Returns a text that describes the possible fault and the handler's place.
std::string torn_text(const RaceAnalysis::Found& found, const DebugInfo& debug, std::uint32_t clock_hz);
/// Returns the fix: "copy it with interrupts off …"
std::string fix_of(RaceAnalysis::AccessKind kind);

class TornAccess final : public Detector {
 public:
  TornAccess(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  void entered(int vector, robosim::avr::Cycle at) override;
  void left() override;
  std::vector<Detected> found() const override;

 private:
  Machine& machine_;
  const DebugInfo& debug_;
  RaceAnalysis race_analysis_;
  SimTime found_at_ = 0;
};

}  // namespace robosim::exec::avr
