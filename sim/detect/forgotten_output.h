// Finds a pin that should drive a part, but was never set to OUTPUT.
//
//   digitalWrite(13, HIGH);   PORTB |= 1 << 5;      // each of these only switches on the pull-up of an input
//
// The pull-up has 20 to 50 kOhm (ATmega328P, DS40002061B, 29.2). An LED gets a tenth of a milliampere and
// hardly glows; a buzzer stays silent, and a servo does not move. Some motor drivers read the level as high,
// and others do not. Simulated drivers read the level as high, so that the run succeeds. The built-in LED of
// an Uno R3, at pin 13, has an amplifier (LMV358, Arduino_Uno_Rev3-schematic) and lights up. A Nano and many
// clones have no amplifier, so that their LED hardly glows.
//
// A finding is a pin whose pull-up was switched on, and which was never an output. The run must continue for
// 0.1 s or more after the pull-up was switched on. Only pins with one of these parts are examined: motor,
// driver, LED, buzzer, servo, fan, stepper, seven-segment digit, shift register.
//
// A sketch that writes HIGH before it sets the pin to OUTPUT, to avoid a short LOW, is not reported. To fix a
// finding, call pinMode(pin, OUTPUT) in setup(), or set the pin's bit in DDRx.
//
// Not detected: pins to which the sketch wrote only LOW, which changes nothing; displays, radios and other
// parts on a bus; pins without wiring.
#pragma once

#include <optional>
#include <vector>

#include "sim/detect/firmware_detector.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class ForgottenOutput final : public FirmwareDetector, public PinWatcher {
 public:
  ForgottenOutput(exec::Executor& executor, SnapshotRegistry& snapshots,
                  const std::vector<robot::WiredPin>& wiring);

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  std::vector<exec::Detected> found(SimTime now) const override;

 private:
  struct Driven {
    robot::WiredPin wired;
    bool was_output = false;
    std::optional<SimTime> pulled_up;  ///< time at which the pull-up was first switched on
    result::SourceLine where;          ///< source line that switched the pull-up on
  };

  struct State {
    std::vector<Driven> pins;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
