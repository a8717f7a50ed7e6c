// The implementation of a simulation: its agents, and how they advance by ticks (simulation.cpp,
// independent_agents.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/run/agent.h"
#include "sim/run/prepared_map.h"
#include "sim/run/simulation.h"
#include "sim/world/world.h"

namespace robosim::run {

struct Simulation::Impl final : Standstill {
  explicit Impl(const Setup& from);

  const Agent& agent(int number) const;
  int agent_count() const override { return static_cast<int>(agents.size()); }
  const State& state(int number) const override { return agent(number).state(); }
  const Sample& sample(int number) const override { return agent(number).sample(); }
  const judge::Outcome* outcome(int number) const override { return agent(number).outcome(); }
  std::vector<std::uint8_t> eeprom(int number) const override { return agent(number).eeprom(); }
  void add(std::vector<scenario::Step> steps, int number) override {
    if (agent(number).finished())
      throw InputError("the robot already has its verdict, so it accepts no more changes");
    agents[static_cast<std::size_t>(number)]->add(std::move(steps));
  }
  void check(const Leg& leg) const override;

  void add_agent(const AgentSetup& own);
  void note_acting(std::size_t number) const {
    if (setup.acting) setup.acting->store(static_cast<int>(number), std::memory_order_relaxed);
  }
  bool stand_still(SimTime t);
  bool leg_ends(SimTime t);
  bool tick(SimTime t);
  void go_alone(SimTime end);
  bool look_of(Agent& agent, SimTime end);
  SimTime turns_end(SimTime t, SimTime end) const;
  bool take_turns(SimTime t, SimTime end);
  void take_turn(std::size_t number, SimTime t, SimTime end);
  void go_together(SimTime t, SimTime end);
  void tell_in_order();
  bool rest(SimTime t);
  bool stir(SimTime t);
  void rest_on(SimTime end);
  bool look(SimTime end);
  void catch_up(SimTime t);
  SimTime rest_from(SimTime end) const;
  bool wants_to_stop() const {
    return setup.interrupted && setup.interrupted->load(std::memory_order_relaxed);
  }
  void interrupt(SimTime t);
  void run_until(SimTime end);
  bool over() const {
    for (const auto& agent : agents)
      if (!agent->finished()) return false;
    return true;
  }

  struct Clock {
    SimTime t = 0;
    bool leg_over = true;
  };

  const Setup& setup;
  const std::unique_ptr<PreparedMap> prepared_map;
  world::World& world;
  std::vector<std::unique_ptr<Agent>> agents;
  Clock clock;
  SimTime rests_until = 0;  // in ticks that begin before this time, only firmware acts
  bool rested = false;      // the last tick was a tick of rest, without any event
  bool takes_turns;
  SimTime turns_from = 0;      // before this time, take_turns() is not called
  std::vector<double> sights;  // Agent::sight() of each agent
  std::vector<std::size_t> together;
  std::vector<Agent::Untold> untold;
};

inline bool Simulation::Impl::look(SimTime end) {
  world.step();
  bool left = false;
  for (const auto& agent : agents) left |= look_of(*agent, end);
  return left;
}

// Evaluates an agent. Returns whether it leaves with its verdict now, while others continue.
inline bool Simulation::Impl::look_of(Agent& agent, SimTime end) {
  if (agent.finished() || !agent.evaluate(end) || over()) return false;
  agent.detach(end);
  return true;
}

}  // namespace robosim::run
