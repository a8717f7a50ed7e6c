#include "sim/run/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sim/run/agent.h"
#include "sim/world/world.h"

namespace robosim::run {
namespace {

/// A clock, a world and its agents.
class Simulation final : Standstill {
 public:
  explicit Simulation(const Setup& setup);
  std::vector<judge::Outcome> run();

 private:
  using Agents = std::vector<std::unique_ptr<Agent>>;

  const Agent& agent(int number) const;
  int agent_count() const override { return static_cast<int>(agents_.size()); }
  const State& state(int number) const override { return agent(number).state(); }
  const Sample& sample(int number) const override { return agent(number).sample(); }
  std::vector<std::uint8_t> eeprom(int number) const override { return agent(number).eeprom(); }
  void add(std::vector<scenario::Step> steps, int number) override {
    agent(number);
    agents_[static_cast<std::size_t>(number)]->add(std::move(steps));
  }
  void check(const Leg& leg) const override;

  bool stand_still(SimTime t);
  bool leg_ends(SimTime t);
  void tick(SimTime t);
  void interrupt(SimTime t);
  bool over() const {
    return std::all_of(agents_.begin(), agents_.end(), [](const auto& agent) { return agent->finished(); });
  }
  std::vector<judge::Outcome> outcomes();

  const Setup& setup_;
  grid::Stripes stripes_;
  world::World world_;
  Agents agents_;
};

Simulation::Simulation(const Setup& setup)
    : setup_(setup), stripes_(*setup.map, setup.map->cell_m), world_(*setup.map) {
  for (const AgentSetup& own : setup.agents)
    agents_.push_back(std::make_unique<Agent>(own, Agent::Stage{setup_, stripes_, world_},
                                              static_cast<int>(agents_.size())));
}

const Agent& Simulation::agent(int number) const {
  if (number < 0 || number >= agent_count())
    throw InputError(
        fmt::format("there is no robot {}; they are numbered from 0 to {}", number, agent_count() - 1));
  return *agents_[static_cast<std::size_t>(number)];
}

void Simulation::check(const Leg& leg) const {
  for (const Stop& stop : leg.stops) agent(stop.agent);
  for (const auto& agent : agents_) agent->check(leg);
}

// The controller's turn. False if the run is to end here.
bool Simulation::stand_still(SimTime t) {
  int met = -1;
  for (const auto& agent : agents_)
    if (agent->met() >= 0 && (met < 0 || agent->met() < met)) met = agent->met();
  for (const auto& agent : agents_) agent->stand_still(t, met);
  const Leg leg = setup_.controller->next(*this);
  if (leg.end) return false;
  for (const auto& agent : agents_) agent->begin_leg(leg, t);
  return true;
}

bool Simulation::leg_ends(SimTime t) {
  bool ends = false;
  for (const auto& agent : agents_) ends |= agent->leg_ends(t);
  return ends;
}

void Simulation::tick(SimTime t) {
  const SimTime end = t + kTick;
  for (const auto& agent : agents_) agent->act(t);
  for (const auto& agent : agents_) agent->run_firmware(end);
  world_.step();
  for (const auto& agent : agents_)
    if (!agent->finished() && agent->look(end) && !over()) agent->leave(end);
}

void Simulation::interrupt(SimTime t) {
  for (const auto& agent : agents_)
    if (!agent->finished()) agent->finish(judge::Verdict::interrupted, t);
}

std::vector<judge::Outcome> Simulation::run() {
  for (const auto& agent : agents_) agent->begin();
  bool leg_over = true;
  for (SimTime t = 0; t < setup_.limit && !over(); t += kTick) {
    if (setup_.controller && leg_over && !stand_still(t)) interrupt(t);
    if (over()) break;
    if (setup_.reached) setup_.reached->store(t, std::memory_order_relaxed);
    tick(t);
    if (setup_.interrupted && setup_.interrupted->load(std::memory_order_relaxed)) interrupt(t + kTick);
    leg_over = setup_.controller && leg_ends(t + kTick);
  }
  for (const auto& agent : agents_)
    if (!agent->finished()) agent->time_out(setup_.limit);
  return outcomes();
}

std::vector<judge::Outcome> Simulation::outcomes() {
  std::vector<judge::Outcome> all;
  for (const auto& agent : agents_) all.push_back(agent->take_outcome());
  return all;
}

}  // namespace

std::vector<judge::Outcome> simulate(const Setup& setup) { return Simulation(setup).run(); }

}  // namespace robosim::run
