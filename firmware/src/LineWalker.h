// Drives a robot along lines from landmark to landmark, and tracks its position. It is a Walker for nav/
// (nav/Landmark.h describes its members), with five analog sensors, two motors, two encoders and a bumper.
//
//                        1 2 3 4 5      the sensors, in a row across the line, ahead of the axle
//                            |
//                    [L]-----+-----[R]  the axle
//
// Every 5 ms the robot reads its sensors, adds up the rotation of its wheels, and controls its motors:
//
//   - Steering. e is the distance of the line to the right of the middle sensor (mm). The robot turns at
//     w = steering * e (rad/s, clockwise). This returns the sensors to the line with the time constant
//     1 / (steering * sensors_ahead), and the axle follows.
//   - Speed. Each wheel has a target position for the present time. Its duty cycle is
//     duty_per_speed * speed + duty_per_mm * (target position - actual position).
//
// Landmarks.
//   arm       an outer sensor gets dark, and more of the row is dark than one line can cover.
//             The sensor stays dark for a line's width; the middle of this width is the arm's centre line.
//   ahead     a line is still under the row when the row has passed the arms.
//   bend      one arm and nothing ahead. The robot rolls on until its axle is over the corner, and turns.
//   junction  two or more lines lead on. The robot rolls on until its axle is over the junction.
//   end       no sensor is dark, and the line was not lost to a side. The robot rolls on until its axle is
//             over the end. If a line reappears before that, the robot has crossed a gap.
//   blocked   the bumper is pressed. The robot stops and waits. After patience_ms it backs up a little.
//             Near the last landmark or corner, it backs up onto that place instead. Without this, the
//             sensors would be past that place after a turn, and find no line.
//
// The robot follows smooth bends with a radius of 150 mm to 1 m. It treats tighter bends as corners, or
// follows them. At a radius of about 130 mm it may mistake a bend for a corner, and lose the line.
//
// Position. The wheels measure the distance (ds) and the turn: (left - right) / track. The heading is stored
// as quarter turns and a remaining angle. Lines run at multiples of a quarter turn, so each step reduces a
// remaining angle below 0.15 rad by the share ds / 150 mm. So errors of unequal wheels do not add up.
// When the robot leaves a landmark along a line, the coordinate across the line is set to the landmark's.
//
// follow(), leave() and begin() return after the robot has finished the motion.
//
// To adapt the walker to another robot, override some of the settings below. They are constants, so that they
// take no memory:
//
//   struct MySettings : LineWalkerSettings { static constexpr float wheel = 42; };
//   LineWalkerOf<MySettings> walker(sensors, motors, encoders, BUMPER_PIN);
//
// Set the sensors' range (LineSensors::setRange or calibrate) so that a line gives about 1000. A sketch can
// have only one LineWalker (WheelEncoders.h explains why).
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
  static constexpr float periods = 154.35f;      ///< encoder periods per channel, for a turn of a wheel
  static constexpr float track = 98;             ///< distance between the wheels
  static constexpr float sensors_ahead = 70;     ///< distance from the axle to the sensors
  static constexpr float pitch = 9.525f;         ///< distance between two sensors
  static constexpr float line = 20;              ///< width of a line
  static constexpr float duty_per_speed = 0.2f;  ///< duty (above smallest_duty) per mm/s: 255 / top speed
  static constexpr uint8_t smallest_duty = 20;   ///< the duty at which the wheels just turn

  // Driving.
  static constexpr float cruise = 300;
  static constexpr float turning = 150;        ///< speed of the wheels when turning on the spot
  static constexpr float creeping = 60;        ///< speed at the end of a roll or a turn
  static constexpr float acceleration = 1500;  ///< mm/s2
  static constexpr float steering = 0.2f;      ///< rad/s for each mm that the line is off
  static constexpr float slowing = 6;          ///< speed reduction, mm/s, for each mm that the line is off
  static constexpr float duty_per_mm = 4;      ///< duty for each mm that a wheel lags

  static constexpr uint16_t patience_ms = 4000;  ///< time for which the robot waits for an obstacle to leave
};

template <class Settings>
class LineWalkerOf {
 public:
  static constexpr bool kKnowsPlaces = true;

  LineWalkerOf(LineSensors& sensors, DriveMotors& motors, WheelEncoders& encoders, uint8_t bumper_pin)
      : sensors_(sensors), motors_(motors), encoders_(encoders), bumper_pin_(bumper_pin) {}

  /// Initialises the hardware. Call it in setup().
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

  // Performs a step: drives at these wheel speeds, waits for the step's end, reads sensors, updates the pose.
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

  uint32_t due_us_ = 0;  ///< due time of the next step
  uint16_t steps_ = 0;   ///< steps driven since the last landmark
  // Position and heading.
  nav::Heading heading_ = 0;
  float off_ = 0;                  ///< remaining angle, clockwise from heading_, rad
  float x_ = 0, y_ = 0;            ///< mm, in the coordinates of nav::Place
  float travelled_ = 0;            ///< mm, since follow() began
  float turned_ = 0;               ///< rad, clockwise, since the turn began
  bool fade_ = false;              ///< off_ decays, because the robot follows a line
  float mark_x_ = 0, mark_y_ = 0;  ///< position of the last landmark
  // Motion of the wheels.
  float speed_ = 0;                           ///< speed reached by acceleration so far
  float behind_left_ = 0, behind_right_ = 0;  ///< lag of each wheel, mm
  bool blocked_ = false;
  bool from_line_ = false;  ///< the robot began in the middle of a line, and has met no landmark yet
  nav::Heading start_heading_ = 0;
  // Kind and position of the last landmark or corner. If blocked nearby, the robot backs up onto that place.
  Passed passed_ = Passed::nothing;
  float passed_at_ = 0;
  nav::Heading passed_heading_ = 0;  ///< heading on arrival at the corner
  nav::LandmarkKind passed_kind_ = nav::LandmarkKind::line;
  uint8_t passed_arms_ = 0;
  bool returned_ = false;  ///< the robot has backed up onto the landmark or corner
  bool deaf_ = false;      ///< the robot turns away from an obstacle: the bumper is ignored
  uint8_t arms_ = 0;       ///< arms of the junction
  uint8_t still_ = 0;      ///< number of successive steps without an encoder count
};

/// The walker with the settings above, for the robot uno5.
typedef LineWalkerOf<LineWalkerSettings> LineWalker;

#include "LineWalkerDriving.h"
#include "LineWalkerLandmarks.h"

#endif
