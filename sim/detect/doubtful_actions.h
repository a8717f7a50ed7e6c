// Detects calls of the Arduino API, and changes of timers, that do not have the effect that the sketch
// expects. The compiler gives no warning, because the values come from variables.
//
// lost_pwm: a duty cycle without PWM.
//   const byte motors[] = {5, 7};  for (byte m : motors) analogWrite(m, speed);
//   Pin 7 has no timer. The pin is LOW for values below 128, and HIGH for all other values.
//
//   servo.attach(3);  analogWrite(9, speed);
//   The Servo library takes timer 1, which makes the PWM of pins 9 and 10 of an Uno. The pins then stay LOW,
//   even after detach(). tone(), libraries for infrared or timers, and writes to TCCRnA do the same to other
//   timers.
//
// pwm_range: analogWrite(6, speed - turn);
//   The register of an 8-bit timer gets only the low byte of a value: -30 acts like 226.
//
// no_interrupt: attachInterrupt(digitalPinToInterrupt(pin), count, RISING);
//   The number of a pin without an external interrupt is 255, and the call has no effect. The same is true of
//   other numbers that the board does not have, such as a pin's number instead of its interrupt's number.
//
// long_delay: delay((long)(next - millis()));
//   A negative number becomes a delay of 24 to 49 days.
//
// For a timer, lost_pwm is reported in two cases. Either the timer leaves its PWM modes while an output has
// PWM. Or the sketch writes a duty cycle (OCRnx of a connected output) to a timer outside of PWM modes. In
// both cases, the timer stays outside of PWM modes for at least 10 ms. Shorter times occur while a sketch
// sets up a timer. Duty cycles that are written while the timer is stopped are not reported.
//
// slow_source: see slow_source.h.
//
// On the host, the firmware itself reports these actions. On an AVR, FirmwareActions finds them
// (avr/firmware_actions.h).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hal/board/board_spec.h"
#include "hal/board/firmware_action.h"
#include "sim/detect/firmware_detector.h"
#include "sim/detect/slow_source.h"

namespace robosim::detect {

/// Collects the findings, one for each action and pin.
class DoubtfulActions {
 public:
  explicit DoubtfulActions(const BoardSpec& board) : board_(&board), slow_source_(board) {}

  using Where = std::function<exec::SourceLine()>;

  /// Examines an action. Calls `where` only if the action may be a finding.
  void acted(const FirmwareAction& action, SimTime t, const Where& where);
  /// Drops the states of timers, because the firmware starts again.
  void powered_on() { timers_.clear(); }
  std::vector<exec::Detected> found(SimTime now) const;

 private:
  struct Moment {
    SimTime t = 0;
    exec::SourceLine where;
  };
  /// A timer outside of PWM modes.
  struct TakenTimer {
    int64_t timer = 0;  ///< TimerSpec::number
    Moment taken;
    std::optional<Moment> wrote;  ///< the first write of a duty cycle since `taken`
    bool had_pwm = false;         ///< an output had PWM when the timer was taken
  };

  void add(const char* detector, int64_t key, const std::string& what, const std::string& mend,
           const Moment& moment);
  void used_missing(int64_t number, const char* function, SimTime t, const Where& where);
  void wrote(int64_t number, int64_t value, SimTime t, const Where& where);
  void attached(int64_t number, SimTime t, const Where& where);
  void delayed(int64_t ms, SimTime t, const Where& where);
  void changed_mode(int64_t timer, bool makes_pwm, bool had_pwm, SimTime t, const Where& where);
  std::optional<exec::Detected> told(const TakenTimer& taken, SimTime now) const;
  /// Counts another occurrence of a known finding. Returns false if the finding is new, and there is room for
  /// it.
  bool add_occurrence(const char* detector, int64_t key);

  struct Key {
    const char* detector;
    int64_t argument;
  };

  const BoardSpec* board_;
  std::vector<Key> keys_;              ///< keys of found_
  std::vector<exec::Detected> found_;  ///< sorted by time
  std::vector<TakenTimer> timers_;
  SlowSource slow_source_;
};

class DoubtfulActionsOnHost final : public FirmwareDetector, public exec::ActionWatcher {
 public:
  DoubtfulActionsOnHost(exec::Executor& executor, SnapshotRegistry& snapshots);

  void acted(const FirmwareAction& action, SimTime t) override;
  void powered_on() override { state_.actions.powered_on(); }
  std::vector<exec::Detected> found(SimTime now) const override { return state_.actions.found(now); }

 private:
  struct State {
    DoubtfulActions actions;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
