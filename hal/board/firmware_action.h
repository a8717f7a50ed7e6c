// Describes actions of firmware that may be mistakes: the chip ignores them, or does not do what the sketch
// says. The target host reports such actions by Host::acted() (hal/host/image.h). On an emulated AVR,
// sim/detect/avr/firmware_actions.h finds them. sim/detect/doubtful_actions.h decides which are findings.
#pragma once

#include <stdint.h>

namespace robosim {

constexpr const char* kPinFunctions[] = {"pinMode", "digitalWrite", "digitalRead", "analogWrite"};

struct FirmwareAction {
  enum class Kind : uint8_t {
    analog_write,      ///< analogWrite(pin, value)
    attach_interrupt,  ///< attachInterrupt(number, …, mode)
    delay,             ///< delay(ms)
    /// A timer has left or entered PWM. Arguments: TimerSpec::number; 1 if it has entered PWM, else 0; the
    /// outputs that had PWM before, one bit each.
    timer_mode,
    /// A duty cycle was written while the timer was not in a PWM mode. Arguments: TimerSpec::number, the
    /// output.
    compare_write,
    /// An AVR's ADC has sampled a pin, and the source of this pin or of the previous one has a resistance.
    /// Arguments: the pin; the capacitor's voltage minus the source's voltage, in nV.
    conversion,
    /// pinMode(), digitalWrite() or another function got a number that is not a digital pin of the board.
    /// Arguments: the number; the function, an index in kPinFunctions.
    missing_pin
  };
  Kind kind;
  int64_t argument[3];
};

}  // namespace robosim
