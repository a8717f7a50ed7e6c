// Detects analogWrite() on a pin that no timer drives. Such a pin is LOW for values below 128, and HIGH for
// all other values.
//   const byte motors[] = {5, 7};   for (byte m : motors) analogWrite(m, speed);      pin 7 has no PWM
//
// If the pin's number is a constant, the compiler already reports the call (sim/build/pin_warnings.h). This
// detector covers pin numbers from variables. A finding is a call with a value from 1 to 254. The values 0
// and 255 work as intended. To fix the sketch, wire the part to a pin with PWM, or use the library SoftPWM.
//
// On the host, LostPwm examines the call in progress and its arguments when the pin's level changes. Calls
// that do not change the level, such as most calls with a value below 128, are not detected. Only the first
// 200 changes of a pin are examined, since some pins carry many pulses. On an AVR, AnalogWriteCalls observes
// the function (avr/analog_write_calls.h).
#pragma once

#include <functional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

/// Collects the findings, one for each pin.
class LostPwmCalls {
 public:
  explicit LostPwmCalls(const BoardSpec& board) : board_(&board) {}

  /// Adds a call if the pin has no PWM and `value` is from 1 to 254. Calls `where` for a pin's first finding.
  void add(Pin pin, int value, SimTime t, const std::function<exec::SourceLine()>& where);
  const std::vector<exec::Detected>& found() const { return found_; }

 private:
  const BoardSpec* board_;
  std::vector<Pin> pins_;              ///< pins of found_
  std::vector<exec::Detected> found_;  ///< sorted by time
};

class LostPwm final : public FirmwareDetector, public PinWatcher {
 public:
  LostPwm(exec::Executor& executor, SnapshotRegistry& snapshots);

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  std::vector<exec::Detected> found(SimTime) const override { return state_.calls.found(); }

 private:
  struct State {
    std::vector<int> asked;  ///< number of examined changes, by pin
    LostPwmCalls calls;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
