// Detects a watchdog that resets the chip, or that the sketch feeds with too little margin.
//
//   wdt_enable(WDTO_250MS);  …  void loop() { wdt_reset(); … }       one pass takes 230 ms, or 270 ms
//
// With 270 ms, the watchdog resets the chip: the robot restarts in the middle of its course, with its motor
// pins in the reset state. The finding contains the sketch's place at the first reset, and the number of
// resets. An intentional reset, for which the sketch waits in an empty loop, is not a finding.
//
// With 230 ms, the simulated chip does not reset, because its exact main clock also counts the watchdog's
// 256 ms. A real watchdog has its own oscillator, of 128 kHz at 3 V and 25 °C. The frequency varies by some
// 10 % between chips, and with heat and a falling supply. One robot in ten then resets occasionally while
// driving. The finding is the longest time between two feeds, if that time exceeds 80 % of the watchdog's
// period.
//
// Not detected: a pass that takes longer in another scenario.
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
  /// Returns whether the chip is in an empty loop.
  bool waits() const;
  double now_s() const { return 1e-9 * static_cast<double>(machine_.now()); }

  const RunningProgram program_;
  Machine& machine_;
  robosim::avr::Cpu& cpu_;
  const robosim::avr::Cpu::Call watchdog_;  ///< previous listener, which is also called
  /// The previous listener for resets, which is also called.
  void (*const reset_)(void* self, std::uint8_t flags);
  void* const reset_self_;
  Cycle last_ = 0, longest_ = 0;
  std::uint32_t longest_power_ = 0;  ///< exponent of the watchdog's period at the time of longest_
  Detected seen_;
  std::vector<Detected> bite_;  ///< empty, or the first reset by the watchdog
};

}  // namespace robosim::detect::avr
