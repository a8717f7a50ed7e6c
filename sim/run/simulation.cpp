#include "sim/run/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/run/simulation_impl.h"

namespace robosim::run {
struct Simulation::Snapshot::Saved {
  const Impl* of = nullptr;
  Impl::Clock clock;
  world::World::State world;
  std::vector<Agent::Saved> agents;
};

namespace {

std::unique_ptr<PreparedMap> scenery_of(const Setup& setup) {
  if (setup.prepared_map && *setup.prepared_map) return std::move(*setup.prepared_map);
  return std::make_unique<PreparedMap>(*setup.map);
}

}  // namespace

Simulation::Impl::Impl(const Setup& from)
    : setup(from), prepared_map(scenery_of(from)), world(prepared_map->world()) {
  if (setup.profile != Profile::ideal) {
    const double usual = world::typical_variation(setup.profile);
    world.vary_floor(NoiseStream(setup.seed, 0, "floor", "brightness"), setup.map->variation.value_or(usual));
    world.wear_lines(NoiseStream(setup.seed, 0, "floor", "wear"));
    world.draw_light_phases(NoiseStream(setup.seed, 0, "light", "phase"));
  }
  for (const AgentSetup& own : setup.agents) add_agent(own);
  takes_turns =
      setup.takes_turns && agents.size() > 1 && !setup.controller && !world.ground() &&
      std::all_of(agents.begin(), agents.end(), [](const auto& one) { return one->may_take_turns(); });
  for (const auto& one : agents) sights.push_back(one->sight());
}

void Simulation::Impl::add_agent(const AgentSetup& own) {
  const int number = agent_count();
  try {
    agents.push_back(std::make_unique<Agent>(own, Agent::Stage{setup, *prepared_map}, number));
  } catch (const InputError& error) {
    if (setup.agents.size() == 1) throw;
    throw BadAgent(error, number);
  }
  if (const auto other = world.first_overlap(static_cast<std::size_t>(number))) {
    BadAgent on_top(InputError("it starts on top of another robot"), number);
    on_top.other = static_cast<int>(*other);
    throw on_top;
  }
}

const Agent& Simulation::Impl::agent(int number) const {
  if (number < 0 || number >= agent_count())
    throw InputError(
        fmt::format("unknown robot: expected a number from 0 to {}, got {}", agent_count() - 1, number));
  return *agents[static_cast<std::size_t>(number)];
}

void Simulation::Impl::check(const Leg& leg) const {
  for (const Stop& stop : leg.stops) agent(stop.agent);
  for (const auto& agent : agents) agent->check(leg);
}

// Calls the controller. Returns false if the controller ends the run.
bool Simulation::Impl::stand_still(SimTime t) {
  int met = -1;
  for (const auto& agent : agents)
    if (agent->met() >= 0 && (met < 0 || agent->met() < met)) met = agent->met();
  for (const auto& agent : agents) agent->publish_pause_state(t, met);
  const Leg leg = setup.controller->next(*this);
  if (leg.end) return false;
  for (const auto& agent : agents) agent->begin_leg(leg, t);
  return true;
}

inline bool Simulation::Impl::leg_ends(SimTime t) {
  bool ends = false;
  for (const auto& agent : agents) ends |= agent->leg_ends(t);
  return ends;
}

// Runs a tick. Returns whether an agent left the run while others continue.
inline bool Simulation::Impl::tick(SimTime t) {
  const SimTime end = t + kTick;
  if (rested) catch_up(t);
  for (const auto& agent : agents) agent->act(t);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    note_acting(i);
    agents[i]->run_firmware(end);
  }
  const bool left = look(end);
  if (end % kRestSpan == 0) rests_until = rest_from(end);
  return left;
}

// Runs ticks of a single robot without a controller, from clock.t to the next check for rest, or fewer ticks.
// Afterwards clock.t is the beginning of the last of these ticks.
void Simulation::Impl::go_alone(SimTime end) {
  Agent& agent = *agents.front();
  SimTime until = std::min(end, clock.t - clock.t % kRestSpan + kRestSpan);
  if (const SimTime every = setup.samples_every; every > 0)
    until = std::min(until, clock.t - clock.t % every + every);
  if (rested) catch_up(clock.t);
  note_acting(0);
  const bool plane = !world.ground();
  std::atomic<SimTime>* const reached = setup.reached;
  SimTime wakes = 0;
  for (;; clock.t += kTick) {
    if (reached) reached->store(clock.t, std::memory_order_relaxed);
    wakes = agent.step_or_sleep(clock.t, wakes);
    if (plane)
      world.step_alone(0);
    else
      world.step();
    if (agent.evaluate(clock.t + kTick) || clock.t + kTick >= until || wants_to_stop()) break;
  }
  if (clock.t + kTick == until) rests_until = rest_from(until);
}

// Runs a tick of agents at rest. Returns whether an agent left the run while others continue.
bool Simulation::Impl::rest(SimTime t) {
  const SimTime end = t + kTick;
  for (const auto& agent : agents) agent->begin_rest(t);
  bool happens = false;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    note_acting(i);
    happens |= agents[i]->run_firmware(end) || agents[i]->has_crashed();
  }
  if (!happens) {
    for (const auto& agent : agents) agent->rest(end);
    rested = true;
    return false;
  }
  return stir(t);
}

// Handles an event in the tick at `t`. Returns whether an agent left the run while others continue.
bool Simulation::Impl::stir(SimTime t) {
  const SimTime end = t + kTick;
  if (rested) catch_up(t);
  const bool left = look(end);
  if (!world.is_still()) rests_until = end;
  return left;
}

void Simulation::Impl::catch_up(SimTime t) {
  rested = false;
  for (const auto& agent : agents) agent->catch_up(t);
}

SimTime Simulation::Impl::rest_from(SimTime end) const {
  if (!setup.leaves_rest_out || !world.is_still()) return end;
  SimTime until = kNever;
  for (const auto& agent : agents) until = std::min(until, agent->rests_until(end));
  return until;
}

void Simulation::Impl::interrupt(SimTime t) {
  for (const auto& agent : agents)
    if (!agent->finished()) agent->finish(judge::Verdict::interrupted, t);
}

// Runs ticks after a tick of rest, as long as they are ticks of rest, too.
void Simulation::Impl::rest_on(SimTime end) {
  const SimTime until = std::min(rests_until, end - kTick);
  Agent* const lone = agents.size() == 1 ? agents.front().get() : nullptr;
  std::atomic<SimTime>* const reached = setup.reached;
  while (rested && clock.t + kTick < until && !wants_to_stop()) {
    clock.t += kTick;
    if (reached) reached->store(clock.t, std::memory_order_relaxed);
    if (!lone) {
      rest(clock.t);
      continue;
    }
    lone->begin_rest(clock.t);
    if (lone->run_firmware(clock.t + kTick) || lone->has_crashed()) {
      stir(clock.t);
      return;
    }
    lone->rest(clock.t + kTick);
  }
}

void Simulation::Impl::run_until(SimTime end) {
  end = std::min(end, setup.limit);
  for (; clock.t < end && !over(); clock.t += kTick) {
    if (setup.controller && clock.leg_over && !stand_still(clock.t)) interrupt(clock.t);
    if (setup.controller && over()) break;
    if (setup.reached) setup.reached->store(clock.t, std::memory_order_relaxed);
    // Runs the last tick in full, not as a tick of rest, so that all of the state can be read afterwards.
    if (clock.t + kTick >= end || wants_to_stop()) rests_until = 0;
    if (takes_turns && clock.t >= std::max(rests_until, turns_from)) {
      if (take_turns(clock.t, turns_end(clock.t, end))) continue;
      turns_from = clock.t - clock.t % kRestSpan + kRestSpan;
    }
    bool left = false;
    if (clock.t < rests_until)
      left = rest(clock.t);
    else if (agents.size() == 1 && !setup.controller)
      go_alone(end);
    else
      left = tick(clock.t);
    if (rested) rest_on(end);
    if (wants_to_stop() && clock.t >= rests_until) interrupt(clock.t + kTick);
    clock.leg_over = setup.controller && (leg_ends(clock.t + kTick) || left);
  }
}

Simulation::Simulation(const Setup& setup) : impl_(std::make_unique<Impl>(setup)) {
  if (setup.reached) setup.reached->store(kLoading, std::memory_order_relaxed);
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) {
    impl_->note_acting(i);
    impl_->agents[i]->begin();
  }
}

Simulation::~Simulation() = default;

SimTime Simulation::now() const { return impl_->clock.t; }

bool Simulation::is_over() const { return impl_->clock.t >= impl_->setup.limit || impl_->over(); }

void Simulation::run_until(SimTime t) { impl_->run_until(t); }

void Simulation::add(std::vector<scenario::Step> steps) { impl_->add(std::move(steps), 0); }

std::vector<judge::Outcome> Simulation::end() {
  std::vector<judge::Outcome> all;
  for (const auto& agent : impl_->agents) {
    if (!agent->finished()) agent->time_out(now());
    all.push_back(agent->take_outcome());
  }
  return all;
}

Simulation::Snapshot Simulation::save() const {
  auto saved = std::make_shared<Snapshot::Saved>();
  *saved = {impl_.get(), impl_->clock, impl_->world.save(), {}};
  saved->agents.reserve(impl_->agents.size());
  for (const auto& agent : impl_->agents) saved->agents.push_back(agent->save());
  Snapshot snapshot;
  snapshot.saved_ = std::move(saved);
  return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
  const Snapshot::Saved& saved = *snapshot.saved_;
  if (saved.of != impl_.get()) throw std::logic_error("a snapshot of another simulation");
  impl_->clock = saved.clock;
  impl_->rests_until = impl_->turns_from = 0;
  impl_->rested = false;  // an exception within a tick may have left it true
  impl_->world.restore(saved.world);
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) impl_->agents[i]->restore(saved.agents[i]);
}

std::vector<judge::Outcome> simulate(const Setup& setup) {
  Simulation simulation(setup);
  simulation.run_until(setup.limit);
  return simulation.end();
}

}  // namespace robosim::run
