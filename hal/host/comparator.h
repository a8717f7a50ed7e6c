// Models the analog comparator on the host (data sheet, chapter 23). The positive input is AIN0 (pin 6) or
// the bandgap. The negative input is AIN1 (pin 7) or the analog input that ADMUX selects.
//
// The comparator samples voltages when ACSR is read or written. It also samples every 64 cycles while its
// interrupt is enabled or timer 1 captures its edges.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Comparator {
 public:
  /// Reads ACSR.
  uint8_t control();
  void set_control(uint8_t value);

  void sync() {
    if (state.now >= due_) look_again();
  }
  /// Returns the time of the next automatic sample.
  SimTime due() const { return due_; }
  bool may_interrupt() const;
  bool pending() const;
  void acknowledge();

 private:
  void look();
  void look_again();
  double negative_volts() const;

  uint8_t control_ = 0;  ///< ACSR without the bit ACO
  bool output_ = false;
  SimTime due_ = kNever;
};

extern Comparator comparator;

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
