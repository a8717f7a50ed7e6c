// Detects torn reads, torn writes and lost updates (detect/tearing.h) in the sketch as it is flashed: the run
// continues. In addition to Tearing's limits, it misses numbers that the compiler accesses by a pointer
// register in this image only.
#pragma once

#include <string>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/detect/tearing.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

/// Returns "torn_read", "torn_write" or "lost_update".
const char* check_of(Tearing::Deed deed);
/// Returns what would happen, and where the handler is, without the fix.
std::string torn_text(const Tearing::Found& found, const DebugInfo& debug, std::uint32_t clock_hz);
/// Returns the fix: "copy it with interrupts off …"
std::string mend_of(Tearing::Deed deed);

class TornNumber final : public Detector {
 public:
  TornNumber(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  void entered(int vector, robosim::avr::Cycle at) override;
  void left() override;
  std::vector<Detected> found() const override;

 private:
  Machine& machine_;
  const DebugInfo& debug_;
  Tearing tearing_;
  SimTime found_at_ = 0;
};

}  // namespace robosim::exec::avr
