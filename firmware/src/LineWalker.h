// A robot that runs along lines from landmark to landmark, and knows where it is. It is a Walker for nav/
// (nav/Landmark.h describes its members), with five analog sensors, two motors, two encoders and a bumper.
//
//                        1 2 3 4 5      the sensors, in a row across the line, ahead of the axle
//                            |
//                    [L]-----+-----[R]  the axle
//
// Every 5 ms it reads its sensors, adds up the rotation of its wheels, and drives on:
//
//   - Steering. e is how far the line is to the right of the middle sensor (mm). The robot turns with
//     w = steering * e (rad/s, clockwise). That brings the sensors back over the line with the time constant
//     1 / (steering * sensors_ahead), and the axle behind them.
//   - Speed. Each wheel has a place where it should be by now, and its duty cycle is
//     duty_per_speed * speed + duty_per_mm * (where it should be - where it is).
//
// Landmarks.
//   arm       an outer sensor gets dark while more of the row is dark than a line alone can cover.
//             It stays so for the width of a line; the middle of that is where the arm leaves.
//   ahead     once the row is past the arms: is there a line under it?
//   bend      one arm and nothing ahead. It rolls on until the axle stands over the corner, and turns.
//   junction  two or more ways. It rolls on until the axle stands over it.
//   end       nothing dark, and the line was not lost to a side. It rolls on until the axle stands
//             over the end. If there is a line again before that, this was a gap.
//   blocked   the bumper is pressed. It stops and waits. If that lasts for patience_ms, it backs up a little,
//             or, near the last landmark or corner, onto that: after a turn between the two, its sensors
//             would be beyond it and see no line.
//
// It follows smooth bends with a radius of 150 mm to 1 m. Tighter ones it takes like corners, or follows. At
// about 130 mm it may confuse the two, and lose the line.
//
// Where it is. The wheels measure the distance (ds) and the turn: (left - right) / track. The heading is
// stored as quarter turns and the remaining angle. Lines run along quarters, so a remaining angle of less
// than 0.15 rad decays with ds / 150 mm. So differences between the wheels do not accumulate. A junction is
// on the line by which the robot leaves it.
//
// follow(), leave() and begin() return when they are done.
//
// Another robot has its own settings, which replace some of those below. They are constants, so that they
// take no memory:
//
//   struct MySettings : LineWalkerSettings { static constexpr float wheel = 42; };
//   LineWalkerOf<MySettings> walker(sensors, motors, encoders, BUMPER_PIN);
//
// Set the sensors' range (LineSensors::setRange or calibrate) so that a line gives about 1000. A sketch can
// have one LineWalker (WheelEncoders.h explains why).
#ifndef LINEKIT_LINE_WALKER_H
#define LINEKIT_LINE_WALKER_H

#include <Arduino.h>

#include "DriveMotors.h"
#include "LineSensors.h"
#include "WheelEncoders.h"
#include "nav/Landmark.h"

/// Settings that depend on the robot. Lengths in mm, speeds in mm/s, angles in rad.
struct LineWalkerSettings {
  // The robot.
  static constexpr float wheel = 32;             ///< diameter
  static constexpr float periods = 154.35f;      ///< of an encoder's channel, for each turn of a wheel
  static constexpr float track = 98;             ///< between the wheels
  static constexpr float sensors_ahead = 70;     ///< of the axle
  static constexpr float pitch = 9.525f;         ///< between two sensors
  static constexpr float line = 20;              ///< width of a line
  static constexpr float duty_per_speed = 0.2f;  ///< of 255, above the smallest duty: 255 / top speed
  static constexpr uint8_t smallest_duty = 20;   ///< the duty at which the wheels just turn

  // How it drives.
  static constexpr float cruise = 300;
  static constexpr float turning = 150;        ///< of the wheels, on the spot
  static constexpr float creeping = 60;        ///< at the end of a roll or a turn
  static constexpr float acceleration = 1500;  ///< mm/s2
  static constexpr float steering = 0.2f;      ///< rad/s for each mm that the line is off
  static constexpr float slowing = 6;          ///< mm/s less for each mm that the line is off
  static constexpr float duty_per_mm = 4;      ///< for each mm that a wheel is behind

  static constexpr uint16_t patience_ms = 4000;  ///< how long it waits for an obstacle to go away
};

template <class Settings>
class LineWalkerOf {
 public:
  static constexpr bool kKnowsPlaces = true;

  LineWalkerOf(LineSensors& sensors, DriveMotors& motors, WheelEncoders& encoders, uint8_t bumper_pin)
      : sensors_(sensors), motors_(motors), encoders_(encoders), bumper_pin_(bumper_pin) {}

  /// Starts all of the hardware. Call it in setup().
  void setup();
  /// Sets a function that is called when the bumper is pressed (true), and when the robot continues (false).
  void setOnPause(void (*on_pause)(bool)) { on_pause_ = on_pause; }

  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place& at);

 private:
  enum class Met : uint8_t { nothing, junction, end, blocked, lost, loop };
  enum class Roll : uint8_t { on_line, straight, off_line };
  enum class Passed : uint8_t { nothing, corner, landmark };

  // Makes a step: drives with these wheel speeds, waits for its time, looks, reckons.
  void step(float left, float right);
  void drive(float forward, float clockwise);
  void spin(float speed);
  void brake();
  void pause();
  void reckon();
  void advance(float along, float aside);

  Met run();
  Met cross();
  bool roll(float to, Roll how);
  bool turnToLine(float target);
  bool face(nav::Heading heading, float angle);
  void backUp(float distance);
  bool backUpToPassed();
  bool darkAhead() const;
  bool armAt(uint8_t sensor) const;
  float offLine() const;
  nav::Landmark landmark(nav::LandmarkKind kind, uint8_t arms);

  static const uint8_t kStepMs = 5;

  LineSensors& sensors_;
  DriveMotors& motors_;
  WheelEncoders& encoders_;
  uint8_t bumper_pin_;
  void (*on_pause_)(bool) = nullptr;

  uint32_t due_us_ = 0;  ///< of the next step
  uint16_t steps_ = 0;   ///< driven since the last landmark
  // Where it is.
  nav::Heading heading_ = 0;
  float off_ = 0;                  ///< clockwise of heading_, rad
  float x_ = 0, y_ = 0;            ///< mm, as nav::Place
  float travelled_ = 0;            ///< mm, since it began to follow
  float turned_ = 0;               ///< rad, clockwise, since it began to turn
  bool fade_ = false;              ///< the angle off fades away: it follows a line
  float mark_x_ = 0, mark_y_ = 0;  ///< the last landmark
  // Motion of its wheels.
  float speed_ = 0;                           ///< the speed that it has accelerated to
  float behind_left_ = 0, behind_right_ = 0;  ///< mm
  bool blocked_ = false;
  bool from_line_ = false;  ///< began in the middle of a line, and has met nothing yet
  nav::Heading start_heading_ = 0;
  // Kind and position of its last landmark; from nearby it backs up onto it.
  Passed passed_ = Passed::nothing;
  float passed_at_ = 0;
  nav::Heading passed_heading_ = 0;  ///< the heading in which it came to the corner
  nav::LandmarkKind passed_kind_ = nav::LandmarkKind::line;
  uint8_t passed_arms_ = 0;
  bool returned_ = false;  ///< it has backed up onto it
  bool deaf_ = false;      ///< turns away from an obstacle: the bumper says nothing new
  uint8_t arms_ = 0;       ///< of the junction
  uint8_t still_ = 0;      ///< steps without a count
};

/// A walker with the settings above: the robot uno5.
typedef LineWalkerOf<LineWalkerSettings> LineWalker;

#include "LineWalkerDriving.h"
#include "LineWalkerLandmarks.h"

#endif
