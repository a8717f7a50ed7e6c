#include "sim/judge/judge.h"

#include <cmath>

namespace robosim::judge {
namespace {
// Sketches pulse their motors; a pause shorter than this does not end "driven".
constexpr SimTime kPulsePause = 200 * kMillisecond;
}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::reached:
      return "reached";
    case Verdict::lost:
      return "lost";
    case Verdict::stuck:
      return "stuck";
    case Verdict::toppled:
      return "toppled";
    case Verdict::hung:
      return "hung";
    case Verdict::ended:
      return "ended";
    case Verdict::crashed:
      return "crashed";
    case Verdict::over_budget:
      return "over_budget";
    case Verdict::timeout:
      return "timeout";
    case Verdict::interrupted:
      return "interrupted";
  }
  return "";
}

ExitStatus exit_status(Verdict verdict) {
  switch (verdict) {
    case Verdict::reached:
      return ExitStatus::ok;
    case Verdict::timeout:
      return ExitStatus::timeout;
    case Verdict::interrupted:
      return ExitStatus::interrupted;
    default:
      return ExitStatus::failed;
  }
}

bool Judge::lost(const Situation& now) {
  if (now.lifted) travel_at_line_ = now.wheel_travel_m;
  if (senses_ && now.sees_line) {
    line_seen_ = Seen{now.t, now.pose->position};
    travel_at_line_ = now.wheel_travel_m;
  }
  return senses_ && now.wheel_travel_m - travel_at_line_ >= kLostAfter;
}

bool Judge::stuck(const Situation& now) {
  if (now.driven) last_driven_ = now.t;
  const Vec2 moved = now.pose->position - anchor_.position;
  const bool moves = dot(moved, moved) >= kStuckMove * kStuckMove ||
                     dot(now.pose->heading, anchor_.heading) < 0.0 ||
                     std::abs(cross(anchor_.heading, now.pose->heading)) >= kStuckTurnSine;
  if (moves || now.lifted || now.t - last_driven_ > kPulsePause) {
    anchor_ = *now.pose;
    anchored_at_ = now.t;
  }
  const Vec2 away = now.pose->position - place_;
  if (dot(away, away) >= kSamePlace * kSamePlace) {
    place_ = now.pose->position;
    place_since_ = now.t;
  }
  return now.t - anchored_at_ >= kStuckAfter;
}

std::optional<Verdict> Judge::look(const Situation& now) {
  const bool is_lost = lost(now);
  const bool is_stuck = stuck(now);
  if (now.toppled) return Verdict::toppled;
  if (is_lost) return Verdict::lost;
  if (now.powered && now.hangs && now.t - now.last_call >= kSilentAfter)
    return now.driven ? Verdict::hung : Verdict::ended;
  if (is_stuck) return Verdict::stuck;
  return std::nullopt;
}

}  // namespace robosim::judge
