#include "sim/world/floor_gaps.h"

#include <algorithm>
#include <cmath>

#include "sim/world/step_constants.h"

namespace robosim::world {
namespace {

constexpr double kTread = 0.006;     // m; assumed width of a wheel's tread
constexpr double kMostShare = 0.98;  // maximum ratio of half the gap to the roller's radius

// Dimensions of a gap, and of a roller at the gap, measured across the gap, m.
struct Meeting {
  double half = 0.0;   // half the gap, without the part that the tread bridges
  double reach = 0.0;  // the roller's radius as seen across the gap; more than `half`
};

Meeting meeting_of(const map::Joint& joint, const FloorGaps::Roller& roller) {
  const Vec2 across = joint.middle.heading;
  const bool is_ball = roller.rolls.x == 0.0 && roller.rolls.y == 0.0;
  const double tread = is_ball ? 0.0 : kTread * std::fabs(cross(roller.rolls, across));
  const double reach = is_ball ? roller.radius : roller.radius * std::fabs(dot(roller.rolls, across));
  return {std::min(joint.half_length - 0.5 * tread, kMostShare * reach), reach};
}

// Returns the speed above which the roller leaves the gap's first edge and falls.
double rolling_speed(double radius) { return std::sqrt(kGravity * radius); }

}  // namespace

FloorGaps::Sunk FloorGaps::sunk(Vec2 p, const Roller& roller) const {
  Sunk sunk;
  for (const map::Joint& joint : joints_) {
    const Vec2 own = joint.middle.to_body(p);
    if (std::fabs(own.x) >= joint.half_length || std::fabs(own.y) > joint.half_width) continue;
    const Meeting meeting = meeting_of(joint, roller);
    const double away = meeting.half - std::fabs(own.x);
    if (!(away > 0.0)) continue;
    const double sine = away / meeting.reach, cosine = std::sqrt(1.0 - sine * sine);
    const double fast = roller.speed / rolling_speed(roller.radius);
    const double falls = fast > 1.0 ? 4.0 / ((1.0 + fast) * (1.0 + fast)) : 1.0;
    const double depth = falls * roller.radius * (1.0 - cosine);
    if (!(depth > sunk.depth)) continue;
    const double slope = falls * roller.radius / meeting.reach * sine / cosine;
    sunk = {depth, joint.middle.heading * (own.x < 0.0 ? -slope : slope)};
  }
  return sunk;
}

double FloorGaps::met2(Vec2 from, Vec2 to, const Roller& roller) const {
  double sum = 0.0;
  for (const map::Joint& joint : joints_) {
    const Vec2 before = joint.middle.to_body(from), after = joint.middle.to_body(to);
    if ((before.x < 0.0) == (after.x < 0.0) || std::fabs(after.y) > joint.half_width) continue;
    const Meeting meeting = meeting_of(joint, roller);
    if (!(meeting.half > 0.0)) continue;
    const double sine = meeting.half / meeting.reach;
    const double met =
        2.0 * sine * std::sqrt(1.0 - sine * sine) * std::min(roller.speed, rolling_speed(roller.radius));
    sum += met * met;
  }
  return sum;
}

}  // namespace robosim::world
