// Detects sketches that use the first reading after a change of the ADC's reference.
//
//   analogReference(INTERNAL);  battery = analogRead(A5);
//   analogReference(DEFAULT);   left = analogRead(A0);
//
// "The first ADC conversion result after switching reference voltage source may be inaccurate, and the user
// is advised to discard this result" (ATmega328P, DS40002061B, 24.5.2). The capacitor at AREF, 100 nF on an
// Uno, must first be charged or discharged. A change from 5 V to 1.1 V takes some milliseconds. In the
// simulation each conversion is exact. A sketch is reported if it
//
//   - changes the reference at least four times, and
//   - uses the first reading after such a change at least three times. The first reading counts as used if
//     the sketch does not read the same pin again within 50 ms.
//
// Sketches that discard a reading, average readings, or set the reference once in setup() are not reported.
// To fix the sketch, discard one reading some milliseconds after the change, or use the same reference for
// all readings.
//
// Sketches that do not use analogRead() are not examined. The detector ignores pauses before a reading,
// although a long pause helps. sim/detect/slow_source.h examines readings after a change of the channel.
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
    std::optional<std::uint8_t> reference;  ///< bits REFS1 and REFS0 of ADMUX; unknown during the call
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
