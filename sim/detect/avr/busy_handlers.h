// Detects interrupt handlers that take most of the processor's time, so that the sketch itself hardly runs.
//
//   OCR2A = 2;  TIMSK2 = _BV(OCIE2A);        // a match each 24 cycles: the handler runs again and again
//
// After each handler, the chip executes one instruction of the program before it starts the next handler
// (DS40002061B, 7.7). Handlers with a higher vector number, such as the handler of millis(), may then never
// run.
//
// A finding is a window of 0.5 s in which handlers took 70 % of the processor's time or more. The finding
// names the handler that took the most. The time of a handler includes the handlers that interrupt it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class BusyHandlers final : public ChipDetector {
 public:
  explicit BusyHandlers(const RunningProgram& program);

  void entered(int vector, Cycle at) override;
  void left() override;
  std::vector<Detected> found(SimTime now) const override;

 private:
  void end_window(Cycle at);

  const RunningProgram program_;
  const Cycle window_;
  std::vector<Cycle> taken_;  ///< cycles in the present window, by vector
  int vector_ = 0;            ///< the outermost running handler
  Cycle entered_ = 0;         ///< when it began
  Cycle began_ = 0;           ///< beginning of the window
  std::optional<Detected> found_;
};

}  // namespace robosim::detect::avr
