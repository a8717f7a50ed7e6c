// Describes actions of firmware that may be mistakes: the chip ignores them, or does something else than the
// sketch says. The target host reports such actions by Host::acted() (hal/host/image.h). On an emulated AVR,
// sim/detect/avr/firmware_actions.h finds them. sim/detect/doubtful_actions.h decides which are findings.
#pragma once

#include <stdint.h>

namespace robosim {

struct FirmwareAction {
  enum class Kind : uint8_t {
    analog_write,      ///< analogWrite(pin, value)
    attach_interrupt,  ///< attachInterrupt(number, …, mode)
    delay,             ///< delay(ms)
    /// A timer has left or entered PWM. Arguments: TimerSpec::number; 1 = it has entered PWM; the outputs
    /// that had PWM before, one bit each.
    timer_mode,
    /// A duty cycle was written while the timer was not in a PWM mode. Arguments: TimerSpec::number, the
    /// output.
    compare_write,
    /// An AVR's ADC has sampled a pin whose source has a resistance, or the next pin after such a pin.
    /// Arguments: the pin; the capacitor's voltage minus the source's voltage, in nV.
    conversion
  };
  Kind kind;
  int64_t argument[3];
};

}  // namespace robosim
