// A watchdog that bites, or is fed too late to be sure of it.
//
//   wdt_enable(WDTO_250MS);  …  void loop() { wdt_reset(); … }       and one pass takes 230 ms, or 270
//
// With 270 ms it resets the chip: the robot begins anew in the middle of its way, with its motors' pins as
// they are after a reset. Told is where the sketch was, the first time and how often. Not told is a reset on
// purpose, a watchdog that is waited for in a loop that does nothing: while (true) {}.
//
// With 230 ms all is well here: the watchdog's 256 ms are counted by the chip's clock. A real one counts them
// by an oscillator of its own, of 128 kHz at 3 V and 25 °C: it is some 10 % off from chip to chip, and with
// heat and a falling supply. Then the chip resets on the way, now and then, on one robot of ten. Told is the
// longest time between two feeds, if it was more than 80 % of what the watchdog waits.
//
// What it cannot see: a pass that takes longer in another world.
//
// Mended by the next longer time, or a wdt_reset() within what takes so long.
#pragma once

#include "sim/avr/cpu.h"
#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

/// `watchdog_bite` and `watchdog_margin`.
class WatchdogMargin final : public Detector {
 public:
  WatchdogMargin(Machine& machine, WhereNow where);
  ~WatchdogMargin() override;
  WatchdogMargin(const WatchdogMargin&) = delete;
  WatchdogMargin& operator=(const WatchdogMargin&) = delete;

  std::vector<Detected> found() const override;

 private:
  void fed();
  void bites(std::uint8_t flags);
  /// The chip does nothing but wait.
  bool waits() const;
  double now_s() const { return 1e-9 * static_cast<double>(machine_.now()); }

  Machine& machine_;
  const WhereNow where_;
  robosim::avr::Cpu& cpu_;
  const robosim::avr::Cpu::Call watchdog_;  ///< who else is told
  /// Who else hears of a reset.
  void (*const reset_)(void* self, std::uint8_t flags);
  void* const reset_self_;
  Cycle last_ = 0, longest_ = 0;
  std::uint32_t longest_power_ = 0;  ///< of the time that the watchdog waited then
  Detected seen_;
  std::vector<Detected> bite_;  ///< none, or the first
};

}  // namespace robosim::exec::avr
