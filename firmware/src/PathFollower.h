// Follows lines that branch, with three digital sensors: left, middle, right.
//
//            |          The robot can meet a bend, a T, a crossing, or the end of a line (a station).
//            |          Its rule is that of the wall follower, who keeps one hand on the wall.
//      ------+------    With the left hand:
//            |            - a branch on the left?  take it;
//          [L M R]        - else the line goes on? follow it;
//            ^            - else turn right until there is a line: that of a bend, or the one it came on.
//
// On lines without closed loops this visits every station and returns to the start, however the lines
// branch. It needs no memory at all. With the right hand everything is mirrored.
//
// Following the edge. The hand is the middle sensor, and it feels the line's edge on the preferred side.
// Dark: steer away from the line; white: steer back to it. So the robot runs along the edge in a fine zigzag.
// The longer the reading stays the same, the harder it steers. Why the edge and not the middle? There the
// sensor on the preferred side is as far from the line as possible. When it gets dark, that is a branch and
// nothing else.
//
// Turning. The sensors are ahead of the axle. The robot first sees a branch and must then roll on until its
// axle is over it. Without encoders it does not know how far it has rolled. But the branch that it has just
// crossed is a ruler, as wide as the line. If the sensor was dark for 70 ms, then 70 ms is one line's width
// ("width"). That holds with a full or an empty battery. Then the robot turns on the spot until the
// middle sensor finds the line.
//
// Mounting. The middle sensor is some centimetres ahead of the axle. The other two are to its sides, a little
// further than the line is wide: 22 mm for a line of 20 mm.
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
    rolling,    ///< on until the axle is over the branch, or over the line's end
    stopping,   ///< before a turn
    turning,    ///< on the spot, until the middle sensor finds a line
    settling    ///< stops the turn
  };

  /// Settings that depend on the robot. Speeds are those of DriveMotors, -255..255. A width is the width of
  /// the line, given in tenths.
  struct Settings {
    int16_t fast = 170;          ///< along the edge: the outer wheel of the zigzag ...
    int16_t slow = 0;            ///< ... and the inner one; 0 brakes it, so that the robot answers at once
    int16_t cruise = 85;         ///< both wheels, straight over a branch or past a line's end
    int16_t turn = 80;           ///< on the spot: one wheel forward, the other backward
    int16_t counter = 130;       ///< against the motion, to stop; 0 leaves that to the motors' brakes
    uint8_t stop_ms = 50;        ///< how long, before a turn ...
    uint8_t settle_ms = 25;      ///< ... and at the end of one
    uint16_t leave_ms = 280;     ///< in a turn: until then it cannot be a branch, only the line it came on
    uint8_t noise_ms = 8;        ///< what lasts shorter than this is not believed
    uint8_t end_tenths = 12;     ///< so far with no line in sight, and the line has ended
    uint8_t past_tenths = 4;     ///< from there until the axle is over the end
    uint8_t branch_tenths = 10;  ///< from a branch's far edge until the axle is over its middle: the sensors'
                                 ///< distance from the axle, less half a line's width, less the way to stop
    uint16_t width_ms = 70;      ///< time for one width until the first branch has been measured
  };

  explicit PathFollower(Side prefer) : prefer_(prefer), width_ms_(settings_.width_ms) {}
  PathFollower(Side prefer, const Settings& settings)
      : settings_(settings), prefer_(prefer), width_ms_(settings.width_ms) {}

  /// Passes what the sensors see (true = line) at `now_ms` (millis()). Call it every 1 to 5 ms.
  void update(bool left, bool middle, bool right, uint32_t now_ms);

  int16_t leftSpeed() const { return left_speed_; }
  int16_t rightSpeed() const { return right_speed_; }
  State state() const { return state_; }
  /// Return the branches taken, and the line ends (including bends to the other side) at which it has turned.
  uint16_t branches() const { return branches_; }
  uint16_t ends() const { return ends_; }
  /// Returns the time for one line's width, as measured at the last branch, in ms.
  uint16_t widthMs() const { return width_ms_; }

 private:
  // `near` is the sensor on the preferred side, `far` the one on the other.
  void follow(bool near, bool middle, bool far);
  void cross(bool near);
  void roll(bool middle, bool far);
  void stop();
  void turn(bool middle);
  void settle();

  void enter(State state);
  /// `turn` > 0 turns to the preferred side.
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
  bool to_branch_ = false;  ///< rolls and turns to a branch, not at a line's end
  bool armed_ = false;      ///< the near sensor has seen the floor since this line began
  bool off_line_ = false;   ///< in a turn to a branch: the middle sensor has left the line it came on
  uint32_t now_ = 0;
  uint32_t entered_ = 0;     ///< when state_ began
  uint16_t step_ = 0;        ///< ms since the last update
  uint16_t near_ms_ = 0;     ///< how long the near sensor has been dark
  uint16_t nothing_ms_ = 0;  ///< how long neither middle nor far sensor have seen a line
  int16_t left_speed_ = 0, right_speed_ = 0;
  uint16_t branches_ = 0, ends_ = 0;
};

#endif
