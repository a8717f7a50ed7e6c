// Torn reads, torn writes and lost updates (detect/tearing.h), in the sketch as it is flashed: the run goes
// on. What it cannot see, beside what Tearing cannot: numbers that the compiler reaches by a pointer register
// there, and not in an image built for checking.
#pragma once

#include <string>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/detect/tearing.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

/// "torn_read", "torn_write" or "lost_update".
const char* check_of(Tearing::Deed deed);
/// What would happen, and where the handler is; without how it is mended.
std::string torn_text(const Tearing::Found& found, const DebugInfo& debug, std::uint32_t clock_hz);
/// "copy it with interrupts off …"
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
