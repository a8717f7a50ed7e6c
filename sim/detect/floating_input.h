// Finds a button or bumper whose pin floats: the sketch reads the pin, and nothing gives it a level while the
// contact is open.
//
//   pinMode(10, INPUT);                      // the button connects pin 10 to ground; INPUT_PULLUP is missing
//   if (digitalRead(10) == LOW) start();
//
// A floating pin picks up noise and reads either level (ATmega328P, DS40002061B, 14.2.6: unconnected pins).
// Simulated pins do the same in the profile `typical` (sim/robot/parts/button.h), so the sketch may start by
// itself, or only on some days.
//
// A finding is a pin that was read alone, or awaited by an interrupt. Its pull-up was never on, and its part
// has no resistor of its own. Not detected: pins that were read only together with their port, and pull-ups
// that were switched on after the first read.
//
// To fix a finding, call pinMode(pin, INPUT_PULLUP), or state the part's resistor in the robot file.
#pragma once

#include <vector>

#include "sim/detect/firmware_detector.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class FloatingInput final : public FirmwareDetector, public PinWatcher {
 public:
  FloatingInput(exec::Executor& executor, SnapshotRegistry& snapshots,
                const std::vector<robot::WiredPin>& wiring);

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  std::vector<exec::Detected> found(SimTime now) const override;

 private:
  struct Contact {
    robot::WiredPin wired;
    bool was_output = false;
  };

  struct State {
    std::vector<Contact> contacts;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
