// Finds a pin that is an output although the part at the pin is an output, too.
//
//   for (int pin = 2; pin <= 10; pin++) pinMode(pin, OUTPUT);      // the start button is at pin 4
//
// The chip and the part then drive against each other. The sketch reads the level that it outputs, not the
// part's level. A pressed button that connects the pin to ground shorts the pin while the pin is HIGH. The
// absolute maximum is 40 mA for each pin (ATmega328P, DS40002061B, 28.1).
//
// A finding is a pin that was an output for 0.1 s or more without a break. Pins through which a sketch
// charges a sensor are outputs for microseconds only. Only these pins are examined: those of buttons,
// bumpers, encoders, infrared receivers, switches and the sensors of a reflectance array; a serial module's
// TXD, and an ultrasonic sensor's echo.
//
// To fix a finding, call pinMode(pin, INPUT) or pinMode(pin, INPUT_PULLUP), or wire the part to another pin.
#pragma once

#include <optional>
#include <vector>

#include "sim/detect/firmware_detector.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class DrivenInput final : public FirmwareDetector, public PinWatcher {
 public:
  DrivenInput(exec::Executor& executor, SnapshotRegistry& snapshots,
              const std::vector<robot::WiredPin>& wiring);

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  void powered_on() override;
  std::vector<exec::Detected> found(SimTime now) const override;

 private:
  struct Input {
    robot::WiredPin wired;
    std::optional<SimTime> output_since;
    exec::SourceLine where;  ///< line that made the pin an output
    bool is_found = false;
  };

  struct State {
    std::vector<Input> inputs;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
