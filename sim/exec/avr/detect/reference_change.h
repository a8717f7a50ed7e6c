// The first reading behind a change of the ADC's reference, taken for good.
//
//   analogReference(INTERNAL);  battery = analogRead(A5);
//   analogReference(DEFAULT);   left = analogRead(A0);
//
// "The first ADC conversion result after switching reference voltage source may be inaccurate, and the user
// is advised to discard this result" (ATmega328P, DS40002061B, 24.5.2): the capacitor at AREF, 100 nF on an
// Uno, has to be charged or emptied first, which takes some milliseconds from 5 V to 1.1 V. Here each
// conversion is exact. What is found is
//
//   a sketch that changes the reference again and again, at least four times,
//   and with the first reading behind it at least three times does not read the same pin again within 50 ms
//
// So who reads once in vain, or averages, and who sets the reference once in setup(), is not told of. Mended
// by a reading that is thrown away, after a few milliseconds; or by one reference for all.
//
// What it cannot see: sketches that do not use analogRead(); whether a pause stands before the reading (a
// long one helps); readings behind a change of the channel
// (sim/judge/slow_source.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class ReferenceChange final : public Detector {
 public:
  ReferenceChange(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  std::vector<Detected> found() const override;

 private:
  /// A call of analogRead().
  struct Read {
    std::uint8_t pin = 0;
    SimTime at = 0;
    std::uint32_t pc = 0;                   ///< of the call
    std::optional<std::uint8_t> reference;  ///< bits of ADMUX; not known before it is over
  };

  const Machine& machine_;
  const DebugInfo& debug_;
  const BoardSpec& board_;
  Read before_, last_;  ///< the last call, and the one before it
  bool has_read_ = false;
  int changes_ = 0;
  std::int64_t used_ = 0;
  std::optional<Read> found_;
};

}  // namespace robosim::exec::avr
