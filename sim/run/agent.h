// One robot in a simulation: its firmware, its body and parts, what its script does to it, its goal, and who
// judges it.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sim/judge/explain.h"
#include "sim/judge/judge.h"
#include "sim/run/simulation.h"
#include "sim/run/stop_conditions.h"
#include "sim/scenario/scenario_player.h"
#include "sim/trace/trace_hash.h"
#include "sim/world/world.h"

namespace robosim::run {

class Agent final : PinWatcher, SerialWatcher, InputWatcher {
 public:
  /// What all agents of a simulation share.
  struct Stage {
    const Setup& setup;
    const grid::Stripes& stripes;
    world::World& world;
  };

  /// `number` counts from 0: the order in which agents act, and part of the address of their noise. Throws
  /// InputError if the set-up makes no sense.
  Agent(const AgentSetup& own, const Stage& stage, int number);
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  /// Tells its listener what was settled, and starts the firmware.
  void begin();

  // The steps of a tick, as simulation.h numbers them. All agents take a step before any takes the next.
  /// 1: what its script does at `t`; its parts schedule their edges.
  void act(SimTime t);
  /// 2 and 3: the firmware runs to `end`, and motors get their commands.
  void run_firmware(SimTime end);
  /// 4: goal and judge look at the world at `end`. Whether that gave a verdict: the agent is then finished.
  bool look(SimTime end);

  /// Ends its run with this verdict.
  void finish(judge::Verdict verdict, SimTime t);
  /// Its time is up: reached where there was no goal.
  void time_out(SimTime limit);
  bool finished() const { return outcome_.has_value(); }
  /// Leaves a finished agent on the floor while others go on: the firmware is off, and nothing is told any
  /// more.
  void leave(SimTime t);
  judge::Outcome take_outcome() { return std::move(*outcome_); }

  // --- driven step by step (step_controller.h) ---
  void begin_leg(const Leg& leg, SimTime t);
  /// At the end of a tick: whether the leg ends here. met() then says which stop did it, or -1.
  bool leg_ends(SimTime t) { return stops_.look(t); }
  int met() const { return stops_.met(); }
  void check(const Leg& leg) const { stops_.check(leg); }
  void add(std::vector<scenario::Step> steps) { player_.add(std::move(steps), progress_); }
  /// Its state where the run stands still at `t`; stop_met: of all agents.
  void stand_still(SimTime t, int stop_met);
  const State& state() const { return state_; }
  const Sample& sample() const { return sample_; }
  std::vector<std::uint8_t> eeprom() const;

 private:
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  void byte_sent(std::uint8_t byte, SimTime t) override;
  void level_seen(Pin pin, bool level, SimTime t) override { listener_->level_seen(pin, level, t); }
  void volts_seen(Pin pin, double volts, SimTime t) override { listener_->volts_seen(pin, volts, t); }
  void byte_received(std::uint8_t byte, SimTime t) override { listener_->byte_received(byte, t); }

  std::optional<judge::Verdict> verdict_at(SimTime end);
  void observe(SimTime end);
  void tell_events(SimTime t);
  Sample sample_at(SimTime t) const;
  judge::Metrics metrics() const;
  judge::Evidence evidence(judge::Verdict verdict, SimTime t);

  const AgentSetup& own_;
  const Setup& setup_;
  int number_;
  Listener* listener_;
  exec::Executor& executor_;
  grid::Start start_;
  grid::Network network_;
  judge::Goal goal_;
  judge::Progress progress_;
  const world::World& world_;
  std::size_t body_number_;
  world::Body& body_;
  RobotPort& board_;
  robot::Robot robot_;
  scenario::ScenarioPlayer player_;
  judge::Judge judge_;
  std::string exceeded_;  ///< the budget that was, as a sentence
  trace::TraceHash hash_;

  Vec2 sensor_midpoint_;
  double cross_track_ = 0.0;
  double cross_track_squares_ = 0.0;
  double cross_track_max_ = 0.0;
  std::int64_t cross_track_ticks_ = 0;
  std::int64_t off_line_ticks_ = 0;
  bool sees_line_ = true;
  int collisions_told_ = 0;
  judge::Events happened_;  ///< in this tick
  std::deque<wire::RunEvent> events_;
  std::string serial_;
  StopConditions stops_;
  State state_;
  Sample sample_;
  std::vector<bool> went_high_, was_output_;
  std::optional<judge::Outcome> outcome_;
};

}  // namespace robosim::run
