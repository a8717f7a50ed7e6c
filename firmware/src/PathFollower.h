// Follows lines that branch, with three digital sensors: left, middle, right.
//
//            |            What the robot can meet: a bend, a T, a crossing, a line's end (a station). At each
//            junction it takes
//      ------+------      the branch on its preferred side; if there is none, straight on; else the other
//      side; and at a
//            |            station it turns round. This is the wall follower's rule ("keep one hand on the
//            wall"): on lines
//          [L M R]        without closed loops it visits every station and comes back to where it began,
//          however the
//            ^            lines branch, and needs no memory at all.
//
// Mounting. The middle sensor stands over the line, some centimetres ahead of the axle. The outer two stand
// further from it than the line is wide, so that on a plain line two sensors are never dark together: dark
// together means a branch. They must not stand much further, or the line can hide between two sensors. For a
// 20 mm line: 22 mm from the middle.
//
// How it decides. The sensors lie ahead of the axle, so the robot first sees a branch, then rolls on until
// the axle stands over the junction. While it rolls it notes on which sides a branch went by, and whether a
// line goes on ahead:
//
//   outer sensor and middle dark together for noise_ms      a branch on that side
//   any sensor dark in the last part of the roll            the line goes on ahead
//   nothing dark for end_ms                                 the line has ended: a station
//
// Then it turns on the spot, ignores the line it stands on, and stops turning when the middle sensor finds
// the branch.
//
// There are no encoders: the roll is timed, so its time belongs to the speed of your robot. Settings says
// how.
//
// This class touches no pin: give it what the sensors see, take the two speeds. It never waits; call update()
// every 1 to 5 ms.
//
//   PathFollower path(PathFollower::Side::left, PathFollower::Settings());
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
  enum class Exit : uint8_t { left, ahead, right, back };
  enum class State : uint8_t {
    following,  ///< on a line
    crossing,   ///< rolls on until the axle is over a junction or bend
    ending,     ///< no line in sight: a gap, or the line's end
    peeking,    ///< looks for the line on the far side before it turns round
    leaving,    ///< turns, still over the line it came on
    turning     ///< turns, until the middle sensor finds a line
  };

  /// All that depends on the robot. Speeds as DriveMotors takes them (-255..255), times in ms.
  struct Settings {
    int16_t cruise = 110;         ///< both wheels on a straight line
    int16_t correct_outer = 120;  ///< when the line has gone to one side: the wheel on the far side of it ...
    int16_t correct_inner = 20;   ///< ... and the wheel on the line's side
    int16_t turn = 90;            ///< each wheel, one way and the other, when turning on the spot
    uint16_t roll_ms = 300;       ///< from the first sight of a branch until the axle is over it:
                                  ///< (distance of the sensors from the axle + half a line's width) / speed
    uint16_t pass_ms = 140;       ///< from the first sight of a branch until it is surely behind the sensors
    uint16_t end_ms = 130;        ///< with no line in sight for this long the line has ended
    uint16_t peek_ms = 150;       ///< a look to the other side, about 20 degrees
    uint16_t leave_ms = 150;      ///< a turn of about 30 degrees: less than from any line to the next
    uint16_t noise_ms = 15;       ///< what is seen for a shorter time is not believed
  };

  PathFollower(Side prefer, const Settings& settings) : settings_(settings), prefer_(prefer) {}

  /// What the sensors see (true = line) at `now_ms` (millis()). Call it every 1 to 5 ms.
  void update(bool left, bool middle, bool right, uint32_t now_ms);

  int16_t leftSpeed() const { return left_speed_; }
  int16_t rightSpeed() const { return right_speed_; }
  State state() const { return state_; }
  /// Junctions and bends passed, and stations at which it turned round.
  uint16_t crossings() const { return crossings_; }
  uint16_t stations() const { return stations_; }

  /// The rule: the preferred side, else straight on, else the other side, else back.
  static Exit choose(Side prefer, bool left, bool ahead, bool right);

 private:
  void follow(bool left, bool middle, bool right);
  void cross(bool left, bool middle, bool right);
  void end(bool left, bool middle, bool right);
  void turn(bool left, bool middle, bool right);
  void enter(State state);
  void startTurn(Side side);
  void spin(Side side);
  void drive(int16_t left, int16_t right);

  Settings settings_;
  Side prefer_;
  State state_ = State::following;
  int8_t line_side_ = 0;  ///< where the line was last off the middle: -1 left, 1 right, 0 under the middle
  Side turn_side_ = Side::left;
  uint32_t now_ = 0;
  uint32_t entered_ = 0;    ///< when state_ began
  uint16_t step_ = 0;       ///< ms since the last update
  uint16_t left_seen_ = 0;  ///< ms for which left and middle were dark together
  uint16_t right_seen_ = 0;
  uint16_t ahead_seen_ = 0;
  uint16_t lost_ = 0;  ///< ms with no line in sight
  bool started_ = false;
  int16_t left_speed_ = 0, right_speed_ = 0;
  uint16_t crossings_ = 0, stations_ = 0;
};

#endif
