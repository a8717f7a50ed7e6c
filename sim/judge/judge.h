// Detects that a run has failed or ended, before its time is up.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "hal/board/sim_time.h"
#include "sim/base/vec.h"
#include "sim/judge/outcome.h"

namespace robosim::judge {

constexpr double kLostAfter = 1.0;                     ///< in m: wheel travel without a line
constexpr SimTime kOffLine = 100 * kMillisecond;       ///< shorter stretches without a line are gaps
constexpr SimTime kLeftLine = kSecond / 2;             ///< a robot without a line for this time has left it
constexpr SimTime kStuckAfter = 3 * kSecond;           ///< duration of driving without moving
constexpr double kStuckMove = 1e-3;                    ///< in m: a robot that moves farther is not stuck
constexpr double kStuckTurnSine = 0.0174524064372835;  ///< sin 1 degree; a robot that turns more is not stuck
constexpr SimTime kPushedAfter = 5 * kSecond;          ///< duration of driving against an obstruction
/// cos 30 degrees. A robot that turns more while it pushes is not stuck.
constexpr double kPushedTurnCosine = 0.8660254037844386;
constexpr double kSamePlace = 0.1;  ///< in m: radius within which a robot counts as being in one place
constexpr double kCircles = 1.0;    ///< in m: radius within which a robot counts as circling
constexpr double kTwoTurns = 12.566370614359172;    ///< 4 pi rad; a robot that turns less does not spin
constexpr double kThreeTurns = 18.849555921538759;  ///< 6 pi rad; a robot that turns less does not circle
constexpr double kSlightTurn = 0.2;                 ///< in rad: a smaller turn has no direction
constexpr SimTime kSilentAfter = 2 * kSecond;       ///< duration without an API call
/// A motor still counts as driven during pauses of up to this length between pulses.
constexpr SimTime kPulsePause = 200 * kMillisecond;
/// A robot still counts as touching an obstruction during pauses of up to this length, in which it bounces
/// off and returns.
constexpr SimTime kTouchPause = 200 * kMillisecond;
constexpr SimTime kDrivePause = kSecond;           ///< a robot still counts as driving during shorter pauses
constexpr SimTime kInOnePlaceAfter = 5 * kSecond;  ///< the explanation mentions a stay of this length

/// The judge's input in each tick.
struct Situation {
  SimTime t = 0;
  const Pose* pose = nullptr;
  double wheel_travel_m = 0.0;  ///< mean path of both wheels so far
  bool sees_line = false;       ///< a line is under a reflectance sensor, or between the outermost two
  bool driven = false;          ///< a motor is driven (robot::Robot::driven())
  bool in_contact = false;      ///< the body touches an obstruction
  bool lifted = false;          ///< the robot is picked up, so that it cannot be lost or stuck
  bool toppled = false;         ///< the robot lies on its side
  bool powered = true;
  SimTime last_call = 0;  ///< time of the firmware's last API call
  bool hangs = false;     ///< the firmware will never call the API again (Executor::hangs)
};

class Judge {
 public:
  /// `senses` is true if the robot has reflectance sensors. A robot without such sensors cannot be lost.
  explicit Judge(bool senses) : senses_(senses) {}

  /// Returns toppled, lost, stuck, hung or ended; nullopt in a normal state. A sketch that now calls no API
  /// function, but may do so later, is in a normal state. The function is inline, because each tick calls it.
  [[gnu::always_inline]] std::optional<Verdict> look(const Situation& now) {
    const bool is_lost = lost(now), is_stuck = stuck(now);
    if (now.toppled || is_lost || is_stuck || now.hangs) [[unlikely]]
      return verdict(now, is_lost, is_stuck);
    return std::nullopt;
  }

  /// The time at which a sensor last saw the line, and the robot's position then.
  struct Seen {
    SimTime at = 0;
    Vec2 position;
  };
  const std::optional<Seen>& line_last_seen() const { return line_seen_; }
  /// Returns where the robot first left the line for kOffLine or longer and found it again later.
  const std::optional<Seen>& line_first_left() const { return first_left_; }
  /// Returns the time since which a stuck robot has been driven without moving, or has been pushing.
  SimTime stuck_since() const { return pushes_ ? pushed_at_ : anchored_at_; }
  /// Returns whether the robot is stuck because it has pushed against an obstruction for kPushedAfter. During
  /// this time it has neither left its place nor turned by 30 degrees.
  bool pushes() const { return pushes_; }
  /// A stay of the axle within some radius of a place.
  struct Stay {
    Vec2 place;                  ///< where it began, in m
    SimTime since = 0;           ///< when it began
    double turned_before = 0.0;  ///< rad; sum of all turns before the stay, above 0 = anticlockwise
    /// For each direction, the last time at which the turns of the stay summed up to less than kSlightTurn.
    SimTime clockwise_since = 0, anticlockwise_since = 0;
  };
  /// Returns the present stay within kSamePlace.
  const Stay& place() const { return place_; }
  /// Returns the present stay within kCircles.
  const Stay& surroundings() const { return surroundings_; }
  /// Returns the sum of all turns since a stay began, in rad; above 0 = anticlockwise. The stay must be
  /// place() or surroundings().
  double turned_during(const Stay& stay) const { return turned_ - stay.turned_before; }
  /// Returns when the robot began to turn in the direction of turned_during(stay). Earlier, it stood, drove
  /// straight, or turned back and forth. Requires that the robot is driving.
  SimTime turns_since(const Stay& stay) const {
    const bool is_clockwise = turned_during(stay) < 0.0;
    return std::max(drives_since(stay), is_clockwise ? stay.clockwise_since : stay.anticlockwise_since);
  }
  /// Returns the time when a motor was last driven.
  SimTime last_driven() const { return last_driven_; }
  /// Returns whether motors are driven, ignoring pauses shorter than kDrivePause.
  bool drives(SimTime t) const { return t - last_driven_ < kDrivePause; }
  /// Returns the time since which the robot has been driving at its present place. Requires that the robot is
  /// driving.
  SimTime drives_here_since() const { return drives_since(place_); }
  /// Returns the time since which the robot has been driving during a stay. Requires that the robot is
  /// driving.
  SimTime drives_since(const Stay& stay) const { return std::max(stay.since, driven_since_); }

 private:
  bool lost(const Situation& now);
  bool stuck(const Situation& now);
  bool stuck_in_contact(const Situation& now);
  void count_turns(Stay& stay, SimTime t) const {
    if (turned_during(stay) > -kSlightTurn) stay.clockwise_since = t;
    if (turned_during(stay) < kSlightTurn) stay.anticlockwise_since = t;
  }
  /// Accepts the situation by value, so that it stays in registers.
  static std::optional<Verdict> verdict(Situation now, bool is_lost, bool is_stuck);

  bool senses_;
  std::optional<Seen> line_seen_, first_left_;
  double travel_at_line_ = 0.0;
  SimTime last_driven_ = -2 * kDrivePause, driven_since_ = 0;
  SimTime anchored_at_ = 0;
  Pose anchor_;
  bool touches_ = false, pushes_ = false;
  SimTime contact_at_ = 0, pushed_at_ = 0;
  Pose pushed_from_;
  double turned_ = 0.0;  ///< rad; sum of all turns, above 0 = anticlockwise
  Stay place_, surroundings_;
};

[[gnu::always_inline]] inline bool Judge::lost(const Situation& now) {
  if (now.lifted) travel_at_line_ = now.wheel_travel_m;
  if (senses_ && now.sees_line) {
    if (line_seen_ && now.t - line_seen_->at >= kOffLine && !first_left_) [[unlikely]]
      first_left_ = line_seen_;
    line_seen_.emplace(Seen{now.t, now.pose->position});
    travel_at_line_ = now.wheel_travel_m;
    return false;
  }
  return senses_ && now.wheel_travel_m - travel_at_line_ >= kLostAfter;
}

[[gnu::always_inline]] inline bool Judge::stuck(const Situation& now) {
  if (now.driven) {
    if (now.t - last_driven_ > kDrivePause) driven_since_ = now.t;
    last_driven_ = now.t;
  }
  const Vec2 moved = now.pose->position - anchor_.position;
  const bool moves = dot(moved, moved) >= kStuckMove * kStuckMove ||
                     dot(now.pose->heading, anchor_.heading) < 0.0 ||
                     std::abs(cross(anchor_.heading, now.pose->heading)) >= kStuckTurnSine;
  if (moves || now.lifted || (!now.driven && now.t - last_driven_ > kPulsePause)) {
    const double turn = cross(anchor_.heading, now.pose->heading);  // the sine of a small angle
    anchor_ = *now.pose;
    anchored_at_ = now.t;
    turned_ += turn;
    const Vec2 away = now.pose->position - place_.place;
    count_turns(place_, now.t);
    count_turns(surroundings_, now.t);
    if (dot(away, away) >= kSamePlace * kSamePlace) {
      place_ = {now.pose->position, now.t, turned_, now.t, now.t};
      const Vec2 farther = now.pose->position - surroundings_.place;
      if (dot(farther, farther) >= kCircles * kCircles) surroundings_ = place_;
    }
  }
  if (now.t - anchored_at_ >= kStuckAfter) return true;
  if (now.in_contact || touches_) [[unlikely]]
    return stuck_in_contact(now);
  return false;
}

}  // namespace robosim::judge
