// A pin that is to drive something, and was never set to OUTPUT.
//
//   digitalWrite(13, HIGH);   PORTB |= 1 << 5;      both only turn on the pull-up of an input
//
// The pull-up has 20 to 50 kOhm (ATmega328P, DS40002061B, 29.2): an LED gets a tenth of a milliampere and
// hardly glows, a buzzer and a servo stay silent, and a motor driver's input may or may not be high enough,
// which changes with the module that was bought. Here drivers take it for high, so that the run goes well.
// The LED on an Uno R3 itself, at pin 13, has an amplifier (LMV358, Arduino_Uno_Rev3-schematic) and shines;
// those on a Nano and on many clones have none.
//
// What is found is a pin with a motor, driver, LED, buzzer, servo, fan, stepper or shift register on it that
// was an input with its pull-up on, and was no output at any time, at least a tenth of a second later. So who
// writes HIGH first and sets the pin to OUTPUT then, which spares a short LOW, is not told of. Mended by
// pinMode(pin, OUTPUT) in setup(), or the pin's bit in DDRx.
//
// What it cannot see: pins that were written LOW only, for that changes nothing; displays, radios and
// whatever else hangs on a bus; pins to which nothing is wired.
#pragma once

#include <optional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"
#include "sim/robot/robot.h"

namespace robosim::judge {

class ForgottenOutput {
 public:
  static constexpr const char* kName = "forgotten_output";

  ForgottenOutput(const BoardSpec& board, const std::vector<robot::WiredPin>& wiring);

  /// Of every pin, while `executor` runs.
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t, exec::Executor& executor);
  /// At the end of the run, `now`.
  std::vector<exec::Detected> found(SimTime now) const;

 private:
  struct Driven {
    robot::WiredPin wired;
    bool was_output = false;
    std::optional<SimTime> pulled_up;  ///< first
    wire::SourceLine where;            ///< then
  };

  std::vector<Driven> pins_;
};

}  // namespace robosim::judge
