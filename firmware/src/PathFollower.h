// Follows lines that branch, with three digital sensors: left, middle, right.
//
//            |          The robot can meet a bend, a T, a crossing, or the end of a line (a station).
//            |          The robot follows the wall-follower rule: keep one hand on the wall.
//      ------+------    With the left hand:
//            |            - if a branch leads to the left, take it;
//          [L M R]        - else if the line goes on, follow it;
//            ^            - else turn right to the next line: the line after a bend, or the line of arrival.
//
// On lines without closed loops this rule visits every station and returns to the start, however the lines
// branch. It needs no memory at all. With the right hand everything is mirrored.
//
// Following the edge. The middle sensor is the hand: it detects the line's edge on the preferred side. If the
// sensor is dark, the robot steers away from the line. If the sensor is white, the robot steers back to the
// line. So the robot runs along the edge in a fine zigzag. The longer the reading stays the same, the further
// the robot turns. With the middle sensor on this edge, the sensor on the preferred side is farthest from the
// line. If that sensor gets dark, it has found a branch and nothing else.
//
// Turning. The sensors are ahead of the axle. After detecting a branch, the robot must roll on until its axle
// is over the branch. Without encoders it cannot measure the distance directly. As a ruler, it uses the
// branch that it has just crossed, since a branch is as wide as the line. If the sensor was dark for 70 ms,
// one line's width ("width") takes 70 ms, with a full or an empty battery. Then the robot turns on the spot
// until the middle sensor finds the line.
//
// Mounting. The middle sensor is some centimetres ahead of the axle. The other two are on its sides, a little
// further away than the line is wide: 22 mm for a line of 20 mm.
//
// This class does not access pins: pass the sensors' values, and use the two speeds. It never waits; call
// update() every 1 to 5 ms.
//
//   PathFollower path(PathFollower::Side::left);
//   void loop() {
//     sensors.read();
//     path.update(sensors.onLine(0), sensors.onLine(1), sensors.onLine(2), millis());
//     motors.drive(path.leftSpeed(), path.rightSpeed());
//     delay(2);
//   }
#ifndef LINEKIT_PATH_FOLLOWER_H
#define LINEKIT_PATH_FOLLOWER_H

#include <stdint.h>

class PathFollower {
 public:
  enum class Side : uint8_t { left, right };
  enum class State : uint8_t {
    following,  ///< runs along the line's edge
    crossing,   ///< a branch is under the sensor of the preferred side
    rolling,    ///< rolls on until the axle is over the branch, or over the line's end
    stopping,   ///< brakes before a turn
    turning,    ///< turns on the spot, until the middle sensor finds a line
    settling    ///< stops the turn
  };

  /// Settings that depend on the robot. Speeds are as for DriveMotors, -255..255. Distances are in tenths of
  /// the line's width.
  struct Settings {
    int16_t fast = 170;          ///< along the edge: the outer wheel of the zigzag ...
    int16_t slow = 0;            ///< ... and the inner one; 0 brakes it, so that the robot responds at once
    int16_t cruise = 85;         ///< both wheels, straight over a branch or past a line's end
    int16_t turn = 80;           ///< on the spot: one wheel forward, the other backward
    int16_t counter = 130;       ///< reverse speed to stop; 0 relies on the motors' brakes
    uint8_t stop_ms = 50;        ///< duration of braking before a turn ...
    uint8_t settle_ms = 25;      ///< ... and at the end of a turn
    uint16_t leave_ms = 280;     ///< in a turn to a branch, a line before this time is the line of arrival
    uint8_t noise_ms = 8;        ///< shorter signals are ignored
    uint8_t end_tenths = 12;     ///< distance without a line after which the line has ended
    uint8_t past_tenths = 4;     ///< further distance until the axle is over the line's end
    uint8_t branch_tenths = 10;  ///< from a branch's far edge until the axle is over its middle: the sensors'
                                 ///< distance from the axle, less half a line's width, less braking distance
    uint16_t width_ms = 70;      ///< assumed time for one width, until the first branch has been measured
  };

  explicit PathFollower(Side prefer) : prefer_(prefer), width_ms_(settings_.width_ms) {}
  PathFollower(Side prefer, const Settings& settings)
      : settings_(settings), prefer_(prefer), width_ms_(settings.width_ms) {}

  /// Updates the speeds from the sensors (true = line) at `now_ms` (millis()). Call it every 1 to 5 ms.
  void update(bool left, bool middle, bool right, uint32_t now_ms);

  int16_t leftSpeed() const { return left_speed_; }
  int16_t rightSpeed() const { return right_speed_; }
  State state() const { return state_; }
  /// Return the number of branches taken, and of line ends (or bends to the other side) at which the robot
  /// turned.
  uint16_t branches() const { return branches_; }
  uint16_t ends() const { return ends_; }
  /// Returns the time for one line's width, as measured at the last branch, in ms.
  uint16_t widthMs() const { return width_ms_; }

 private:
  // `near` is the sensor on the preferred side, `far` the sensor on the other side.
  void follow(bool near, bool middle, bool far);
  void cross(bool near);
  void roll(bool middle, bool far);
  void stop();
  void turn(bool middle);
  void settle();

  void enter(State state);
  /// Sets the speeds of both wheels. `turn` > 0 turns to the preferred side.
  void drive(int16_t speed, int16_t turn);
  uint16_t since() const { return static_cast<uint16_t>(now_ - entered_); }
  /// Returns the time for a number of tenths of a width.
  uint16_t timeFor(uint8_t tenths) const {
    return static_cast<uint16_t>(static_cast<uint32_t>(width_ms_) * tenths / 10);
  }

  Settings settings_;
  Side prefer_;
  uint16_t width_ms_;
  State state_ = State::following;
  bool started_ = false;
  bool to_branch_ = false;  ///< turns to a branch, not at a line's end
  bool armed_ = false;      ///< the near sensor has been off the line at least once since this line began
  bool off_line_ = false;   ///< in a turn to a branch: the middle sensor has left the line of arrival
  uint32_t now_ = 0;
  uint32_t entered_ = 0;     ///< time at which state_ began, in ms
  uint16_t step_ = 0;        ///< ms since the last update
  uint16_t near_ms_ = 0;     ///< time for which the near sensor has been dark
  uint16_t nothing_ms_ = 0;  ///< time for which neither the middle nor the far sensor has detected a line
  int16_t left_speed_ = 0, right_speed_ = 0;
  uint16_t branches_ = 0, ends_ = 0;
};

#endif
