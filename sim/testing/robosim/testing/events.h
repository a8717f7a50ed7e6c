// Defines events that end a drive: ASSERT_TRUE(robot.run_until(serial_says("Ready"), within(5_s))).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robosim/testing/quantities.h"

namespace robosim::testing {

/// An event. The event `a || b` occurs when `a` or `b` occurs. Events are checked every millisecond.
class Event {
 public:
  enum class Kind { serial, line, note, event, visited, at, reading, pin, motors, rest, end };
  struct One {
    Kind kind;
    std::string text;    ///< text, regular expression, note, kind of event, station, part, pin, or verdict
    bool level = true;   ///< for reading, pin, motors
    Duration time{};     ///< for rest
    std::string clause;  ///< for messages: `the sketch says "Ready"`
  };

  explicit Event(One one) : any_{std::move(one)} {}
  const std::vector<One>& any() const { return any_; }
  /// Returns a text such as "the sketch says "Ready", or the LED is on".
  std::string clause() const;

  friend Event operator||(Event a, const Event& b) {
    a.any_.insert(a.any_.end(), b.any_.begin(), b.any_.end());
    return a;
  }

 private:
  std::vector<One> any_;
};

/// Occurs when the sketch has sent this text. The search begins after the last text that was found, and after
/// the last action (press, send, …). Text that the sketch sent before send() is therefore not mistaken for
/// the answer.
Event serial_says(const std::string& text);
/// Occurs when this regular expression matches part of a complete line; the line end is not included. The
/// syntax is RE2, which is the syntax of ECMAScript without lookahead and back references. The search begins
/// at the same position as in serial_says().
Event serial_matches(const std::string& regex);
/// Occurs when a display shows a text that begins with `text`; "|" joins the lines of a display. Also occurs
/// when a Bluetooth module has received a line that begins with `text`.
Event tells(const std::string& part, const std::string& text);
/// Occurs when the body has covered the station's centre at least once since the start. `station` is a number
/// or a name.
Event visits(const std::string& station);
Event visits(int station);
/// Occurs while the body covers a station's centre.
Event is_at(const std::string& station);
Event is_at(int station);
/// turns_on() occurs when an LED, or another part that people can see or touch, is on. turns_off() occurs
/// when the part is off.
Event turns_on(const std::string& part);
Event turns_off(const std::string& part);
/// pin_goes_high() occurs when the firmware drives a pin ("D13", "A5") high or with PWM. pin_goes_low()
/// occurs when the firmware drives the pin low. A change of any duration counts.
Event pin_goes_high(const std::string& pin);
Event pin_goes_low(const std::string& pin);
/// motors_start() occurs when any motor is commanded. motors_stop() occurs when no motor is commanded.
Event motors_start();
Event motors_stop();
/// Occurs when no wheel has turned for this duration.
Event stands_still(Duration time = 500_ms);
/// Occurs when the robot has hit a wall, an obstacle, the map's edge or another robot.
Event collides();
/// Occurs when the run has ended with this verdict, such as "lost" or "crashed" (docs/reference/verdicts.md).
/// A test that waits for a verdict does not fail because of this verdict.
Event ends(const std::string& verdict);

}  // namespace robosim::testing
