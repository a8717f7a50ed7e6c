#include "sim/judge/judge.h"

namespace robosim::judge {

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

bool Judge::stuck_in_contact(const Situation& now) {
  const Vec2 moved = now.pose->position - pushed_from_.position;
  const bool drives = now.driven || now.t - last_driven_ <= kPulsePause;
  const bool goes_on = touches_ && drives && !now.lifted && dot(moved, moved) < kSamePlace * kSamePlace &&
                       dot(now.pose->heading, pushed_from_.heading) > kPushedTurnCosine;
  if (now.in_contact) contact_at_ = now.t;
  touches_ = now.t - contact_at_ <= kTouchPause;
  if (!goes_on) {
    pushed_from_ = *now.pose;
    pushed_at_ = now.t;
  }
  return pushes_ = touches_ && now.t - pushed_at_ >= kPushedAfter;
}

std::optional<Verdict> Judge::verdict(Situation now, bool is_lost, bool is_stuck) {
  if (now.toppled) return Verdict::toppled;
  if (is_lost) return Verdict::lost;
  if (now.powered && now.hangs && now.t - now.last_call >= kSilentAfter)
    return now.driven ? Verdict::hung : Verdict::ended;
  if (is_stuck) return Verdict::stuck;
  return std::nullopt;
}

}  // namespace robosim::judge
