// Detects a watchdog that resets the chip, or that the sketch feeds with too little margin.
//
//   wdt_enable(WDTO_250MS);  …  void loop() { wdt_reset(); … }       one pass takes 230 ms, or 270 ms
//
// If a pass takes 270 ms, the watchdog resets the chip. The robot restarts in the middle of its course, with
// its motor pins in the reset state. The finding contains the sketch's line at the first reset, and the
// number of resets. An intentional reset, for which the sketch waits in an empty loop, is not a finding.
//
// If each pass takes 230 ms, the watchdog does not reset the simulated chip. The simulation derives the
// watchdog's period of 256 ms from the exact main clock. A real watchdog has its own oscillator, of 128 kHz
// at 3 V and 25 °C. Its frequency varies by some 10 % between chips, and with heat and a falling supply.
//
// So with passes of 230 ms, some real robots reset occasionally while driving. The finding is the longest
// time between two calls of wdt_reset(), if that time exceeds 80 % of the watchdog's period. A pass that
// takes longer in another scenario is not detected.
//
// To fix the sketch, use the next longer period, or call wdt_reset() within the slow part.
#pragma once

#include "sim/detect/avr/chip_detector.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::detect::avr {

/// Reports the findings `watchdog_bite` and `watchdog_margin`.
class WatchdogMargin final : public ChipDetector {
 public:
  explicit WatchdogMargin(const RunningProgram& program);
  ~WatchdogMargin() override;
  WatchdogMargin(const WatchdogMargin&) = delete;
  WatchdogMargin& operator=(const WatchdogMargin&) = delete;

  std::vector<Detected> found(SimTime) const override;

 private:
  void fed();
  void watchdog_resets(std::uint8_t flags);
  /// Returns whether the chip runs an empty loop, in which the sketch waits for the reset.
  bool waits() const;
  double now_s() const { return 1e-9 * static_cast<double>(machine_.now()); }

  const RunningProgram program_;
  Machine& machine_;
  robosim::avr::Cpu& cpu_;
  const robosim::avr::Cpu::Call watchdog_;  ///< earlier listener, which this object calls
  /// The earlier listener for resets, which this object calls.
  void (*const reset_)(void* self, std::uint8_t flags);
  void* const reset_self_;
  Cycle last_ = 0, longest_ = 0;
  int longest_power_ = 0;  ///< n for a period of 16 ms * 2^n, at the time of longest_
  Detected seen_;
  std::vector<Detected> bite_;  ///< empty, or the first reset by the watchdog
};

}  // namespace robosim::detect::avr
