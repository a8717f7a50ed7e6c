// Runs robots in turns of several ticks while they are far from all others (simulation.h).
#include <algorithm>
#include <tuple>

#include "sim/run/simulation_impl.h"

namespace robosim::run {
namespace {

constexpr SimTime kTurn = 5 * kRestSpan;  // longer turns would need larger distances between robots

}  // namespace

// Returns the time until which robots far from all others may run independently, starting at `t`. No script
// acts before that time, and it is at most the next multiple of kTurn. Returns `t` if the run is to stop.
SimTime Simulation::Impl::turns_end(SimTime t, SimTime end) const {
  if (wants_to_stop()) return t;
  SimTime until = std::min(end, t - t % kTurn + kTurn);
  for (const auto& agent : agents) until = std::min(until, agent->acts_at(t));
  return until;
}

// Runs the ticks from `t` to `end`, or fewer ticks. First runs each robot that is apart from all others, one
// after the other; then runs the remaining robots in lockstep. In a turn of several ticks, a robot's state
// and its copy of the firmware stay in the caches. If no robot is apart, or the turn would be shorter than
// two ticks, returns false and changes nothing.
bool Simulation::Impl::take_turns(SimTime t, SimTime end) {
  if (end < t + 2 * kTick) return false;
  const std::vector<bool>* apart = &world.apart(sights, 1e-9 * static_cast<double>(end - t));
  const auto most = static_cast<std::ptrdiff_t>(agents.size() / 2);
  if (const SimTime soon = t - t % kRestSpan + kRestSpan;
      soon < end && std::count(apart->begin(), apart->end(), true) < most) {
    end = soon;
    apart = &world.apart(sights, 1e-9 * static_cast<double>(end - t));
  }
  together.clear();
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (!(*apart)[i]) together.push_back(i);
  if (together.size() == agents.size()) return false;
  if (rested) catch_up(t);
  for (std::size_t i = 0; i < agents.size(); ++i)
    if ((*apart)[i]) take_turn(i, t, end);
  if (!together.empty()) go_together(t, end);
  if (!untold.empty()) tell_in_order();
  clock.t = end - kTick;
  if (over()) {
    clock.t = 0;
    for (const auto& agent : agents) clock.t = std::max(clock.t, agent->outcome()->time - kTick);
  } else if (end % kRestSpan == 0) {
    rests_until = rest_from(end);
  }
  return true;
}

void Simulation::Impl::take_turn(std::size_t number, SimTime t, SimTime end) {
  Agent& agent = *agents[number];
  agent.tell_later(&untold);
  note_acting(number);
  SimTime wakes = 0;
  for (bool goes_on = true; t < end && goes_on; t += kTick) {
    if (setup.reached) setup.reached->store(t, std::memory_order_relaxed);
    wakes = agent.step_or_sleep(t, wakes);
    world.step_alone(number);
    goes_on = agent.finished() || look_of(agent, t + kTick) || !agent.finished();  // false: all have finished
  }
  agent.tell_later(nullptr);
}

void Simulation::Impl::go_together(SimTime t, SimTime end) {
  for (const std::size_t i : together) agents[i]->tell_later(&untold);
  for (; t < end; t += kTick) {
    if (setup.reached) setup.reached->store(t, std::memory_order_relaxed);
    for (const std::size_t i : together) agents[i]->act(t);
    for (const std::size_t i : together) {
      note_acting(i);
      agents[i]->run_firmware(t + kTick);
    }
    world.step_together(together);
    for (const std::size_t i : together) look_of(*agents[i], t + kTick);
    if (over()) break;
  }
  for (const std::size_t i : together) agents[i]->tell_later(nullptr);
}

void Simulation::Impl::tell_in_order() {
  std::stable_sort(untold.begin(), untold.end(), [](const Agent::Untold& one, const Agent::Untold& other) {
    return std::tuple(one.tick, one.step, one.agent) < std::tuple(other.tick, other.step, other.agent);
  });
  for (const Agent::Untold& one : untold) {
    if (const auto* event = std::get_if<result::RunEvent>(&one.what))
      one.listener->happened(*event);
    else
      one.listener->sampled(std::get<Sample>(one.what));
  }
  untold.clear();
}

}  // namespace robosim::run
