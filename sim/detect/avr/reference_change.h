// Detects sketches that use the first reading after a change of the ADC's reference.
//
//   analogReference(INTERNAL);  battery = analogRead(A5);
//   analogReference(DEFAULT);   left = analogRead(A0);
//
// "The first ADC conversion result after switching reference voltage source may be inaccurate, and the user
// is advised to discard this result" (ATmega328P, DS40002061B, 24.5.2). The capacitor at AREF, 100 nF on an
// Uno, must first be charged or discharged. This takes some milliseconds from 5 V to 1.1 V. In the simulation
// each conversion is exact. A finding is a sketch that
//
//   - changes the reference at least four times,
//   - and at least three times uses the first reading after the change: it does not read the pin again within
//     50 ms.
//
// Sketches that discard a reading, average readings, or set the reference once in setup() are not reported.
// To fix the sketch, discard one reading after a few milliseconds, or use one reference for everything.
//
// Not considered: sketches that do not use analogRead(); a pause before the reading, although a long pause
// helps; readings after a change of the channel (sim/detect/slow_source.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class ReferenceChange final : public ChipDetector {
 public:
  explicit ReferenceChange(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime) const override;

 private:
  /// A call of analogRead().
  struct Read {
    std::uint8_t pin = 0;
    SimTime at = 0;
    std::uint32_t pc = 0;                   ///< address of the call
    std::optional<std::uint8_t> reference;  ///< bits of ADMUX; unknown until the call ends
  };

  const Machine& machine_;
  const DebugInfo& debug_;
  const BoardSpec& board_;
  Read before_, last_;  ///< `last_` is the last call, `before_` the call before it
  bool has_read_ = false;
  int changes_ = 0;
  std::int64_t used_ = 0;
  std::optional<Read> found_;
};

}  // namespace robosim::detect::avr
