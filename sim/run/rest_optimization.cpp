// Makes the simulation of resting robots almost free, as long as nothing moves on the floor. A tick of rest
// runs firmware, parts and detectors, hashes poses, and counts the tick. It skips act() and evaluate(), which
// would repeat their results. They run in full once per kRestSpan, and whenever firmware does something. A
// series of equal checks has the same effect as its last check, which catch_up() performs before anything
// changes.
#include <algorithm>

#include "sim/run/agent.h"

namespace robosim::run {

SimTime Agent::rests_until(SimTime end) const {
  if (setup_.controller || robot_.has_text_outputs() || robot_.fed_volts()) return end;
  if (finished()) return kNever;
  const SimTime next_look = end - end % kRestSpan + kRestSpan;
  if (!progress_.is_settled(body_) || next_look - judge_.stuck_since() >= judge::kStuckAfter ||
      next_look - executor_.last_call() >= judge::kSilentAfter)
    return end;
  const SimTime until = std::min(next_look - kTick, player_.next_act(end));
  const SimTime every = setup_.samples_every;
  return every > 0 ? std::min(until, end - end % every + every - kTick) : until;
}

void Agent::rest(SimTime end) {
  if (finished()) return;
  hash_.pose(body_.pose());
  if (state_.sees_line && end % (kSideCheckEvery * kTick) == 0) look_to_the_side();
  count_tick(end);
  if (detectors_) watch_steering(end);
}

void Agent::catch_up(SimTime t) {
  if (finished()) return;
  progress_.update(body_, t, state_.happened);
  judge_.look({.t = t,
               .pose = &body_.pose(),
               .wheel_travel_m = body_.wheel_travel(),
               .sees_line = state_.sees_line,
               .powered = player_.powered(),
               .last_call = t});
}

}  // namespace robosim::run
