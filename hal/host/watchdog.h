// Models the watchdog on the host. hal/board/avr_watchdog.h describes its modes. After a reset, the sketch
// restarts with MCUSR cleared and the watchdog off, as after an Uno's boot loader. Unlike on the chip, all
// variables are initialised again, including those in .noinit.
#pragma once

#include <stdint.h>

#include "hal/board/avr_watchdog.h"
#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Watchdog {
 public:
  /// Reads the register WDTCSR.
  uint8_t control() const { return watchdog_.read(control_, state.now); }
  void set_control(uint8_t value);
  /// Executes WDR.
  void restart();

  /// Updates the watchdog to the present time. Does not return if it resets the chip.
  void sync() {
    if (due_ <= state.now) sync_due();
  }
  bool pending() const { return control_ & kWdif && control_ & kWdie; }
  void acknowledge() { watchdog_.enter(control_); }
  /// Returns the end of the watchdog's period; kNever if it is off.
  SimTime due() const { return due_; }
  /// Returns whether the watchdog may reset the chip even if firmware never acts again.
  bool may_bite() const { return control_ & kWde; }
  bool may_interrupt() const { return control_ & kWdie; }

 private:
  SimTime period() const;
  void schedule();
  ROBOSIM_RARE void sync_due();

  uint8_t control_ = 0;
  avr::WatchdogControl<SimTime> watchdog_;
  SimTime due_ = kNever;
};

extern Watchdog watchdog;

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
