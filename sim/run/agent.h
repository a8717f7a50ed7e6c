// One robot in a simulation: its firmware, its body and parts, its script, its goal, and its judge.
#pragma once

#include <any>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/detect/detectors.h"
#include "sim/judge/explain.h"
#include "sim/judge/judge.h"
#include "sim/run/append_only_text.h"
#include "sim/run/check_schedule.h"
#include "sim/run/prepared_map.h"
#include "sim/run/scenario/scenario_player.h"
#include "sim/run/simulation.h"
#include "sim/run/stop_conditions.h"
#include "sim/run/trace/trace_hash.h"
#include "sim/world/world.h"

namespace robosim::run {

constexpr SimTime kSettling = 500 * kMillisecond;  ///< start of a run, excluded from the cross-track error

class Agent final : PinWatcher, SerialWatcher, InputWatcher {
 public:
  /// The objects that all agents of a simulation share.
  struct Stage {
    const Setup& setup;
    PreparedMap& prepared_map;
  };

  /// Throws InputError if the set-up is invalid. `number` counts from 0. Agents act in the order of their
  /// numbers. The number also selects the agent's noise streams.
  Agent(const AgentSetup& own, const Stage& stage, int number);
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  /// Reports the resolved settings to the listener, and starts the firmware.
  void begin();

  // The steps of a tick, numbered as in simulation.h. All agents complete a step before any agent begins the
  // next one.
  /// Step 1: runs the script at `t`; the parts schedule their pin edges.
  void act(SimTime t) {
    if (robot_.has_battery() || detectors_ || player_.next_act(t) <= t || !state_.happened.empty())
        [[unlikely]]
      act_in_full(t);
    else
      robot_.begin_tick(t);
  }
  /// Steps 2 and 3: runs the firmware to `end`, and sets the motors' commands. Returns whether a pin or a
  /// motor's command has changed since the tick began.
  bool run_firmware(SimTime end);
  /// Runs steps 1 to 3 of the tick at `t`. Returns the time until which these steps have nothing to do.
  /// `wakes` is the result of the previous call; 0 = unknown.
  SimTime step_or_sleep(SimTime t, SimTime wakes);
  /// Step 4: goal and judge examine the world at `end`. Returns whether they reach a verdict, which finishes
  /// the agent.
  bool evaluate(SimTime end);

  // --- turns of several ticks, for a robot far from all others ---
  /// A report, delayed until all agents have reached its time.
  struct Untold {
    SimTime tick;  ///< beginning of the report's tick
    int step;      ///< number of the step within the tick
    int agent;
    Listener* listener;
    std::variant<result::RunEvent, Sample> what;
  };
  /// Returns whether the agent may ever run several ticks in one turn.
  bool may_take_turns() const;
  double sight() const { return robot_.sight(); }
  /// Returns the time of the script's next action; kNever if the agent has its verdict.
  SimTime acts_at(SimTime t) const { return finished() ? kNever : player_.next_act(t); }
  /// From now on, collects events and samples in `untold` instead of reporting them. If `untold` is null,
  /// reports them immediately.
  void tell_later(std::vector<Untold>* untold) { untold_ = untold; }

  // --- ticks of a robot at rest (rest_optimization.cpp) ---
  /// Returns the time until which the agent rests; `end` if the agent does not rest. In ticks that begin
  /// before that time, evaluate() and the script in act() would only repeat their results. This holds while
  /// nothing in the world moves and no event occurs. Call this function directly after evaluate() at `end`.
  SimTime rests_until(SimTime end) const;
  /// Performs step 1 in a tick of rest.
  void begin_rest(SimTime t) {
    if (detectors_) detectors_->booted(player_.boots());
    robot_.begin_tick(t);
  }
  bool has_crashed() const { return crash_.has_value(); }
  /// Performs step 4 at the end of a tick of rest.
  void rest(SimTime end);
  /// Updates the state after ticks of rest, as if all of them had been evaluated. Call this function before
  /// anything else happens at `t`.
  void catch_up(SimTime t);

  /// Ends the agent's run with this verdict.
  void finish(judge::Verdict verdict, SimTime t);
  /// Ends the agent's run because the time is up. The verdict is "timeout"; without a goal, it is "reached".
  void time_out(SimTime limit);
  bool finished() const { return state_.outcome.has_value(); }
  /// Switches off the firmware of a finished agent while others continue. The robot stays on the floor, and
  /// its listener receives no more reports.
  void detach(SimTime t);
  const judge::Outcome* outcome() const { return finished() ? &*state_.outcome : nullptr; }
  judge::Outcome take_outcome() { return std::move(*state_.outcome); }

  // --- driven step by step (step_controller.h) ---
  void begin_leg(const Leg& leg, SimTime t);
  /// Returns whether the leg ends at `t`, the end of a tick. met() then returns the number of the stop that
  /// ended the leg, or -1.
  bool leg_ends(SimTime t) { return stops_.look(t); }
  int met() const { return stops_.met(); }
  void check(const Leg& leg) const { stops_.check(leg); }
  void add(std::vector<scenario::Step> steps) { player_.add(std::move(steps), progress_); }
  /// Prepares state() and sample() for a pause at `t`. `stop_met` is the number of the stop that ended the
  /// leg, whichever agent the stop concerns; -1 = none.
  void publish_pause_state(SimTime t, int stop_met);
  const run::State& state() const { return state_.shown; }
  const Sample& sample() const { return state_.sample; }
  std::vector<std::uint8_t> eeprom() const;

  // --- snapshots (simulation.h) ---
  struct State {
    Listener* listener;                                               ///< never null; detach() replaces it
    std::string exceeded;                                             ///< the exceeded budget; "" = none
    Vec2 midpoint = {std::numeric_limits<double>::quiet_NaN(), 0.0};  ///< m, midpoint of the line sensors
    double cross_track = 0.0;                                         ///< m, at `midpoint`
    world::FloorProbe line;                                           ///< stripe near `midpoint`
    double cross_track_squares = 0.0;
    double cross_track_max = 0.0;
    std::int64_t cross_track_ticks = 0;
    std::int64_t off_line_ticks = 0;
    bool sees_line = true;
    double line_side = 0.0;     ///< last value of Robot::line_side() that was not small
    double side_command = 0.0;  ///< difference of the commands when the line came to this side
    /// Mean steering since the line came to this side, -2..2; above 0: towards the line. Ignores a command
    /// that was given earlier, unless the command steers towards the line.
    double steered = 0.0;
    int collisions_told = 0;
    SimTime senses_at = 0;   ///< no sensor is examined before this time
    SimTime reports_at = 0;  ///< no periodic work before this time: see is_undisturbed()
    bool stirred = false;    ///< a pin has changed since the tick began
    judge::Events happened;  ///< events in this tick
    std::deque<result::RunEvent> events;
    SimTime sent_at = -1;  ///< time of the last byte sent
    std::string told;      ///< texts that parts have shown, one per line
    run::State shown;
    Sample sample;
    std::vector<bool> went_high, was_output, was_pulled_up;
    std::optional<judge::Outcome> outcome;
  };
  /// All state that changes during a run, except the body's.
  struct Saved {
    State own;
    AppendOnlyText::Copy serial;
    judge::Progress progress;
    judge::Judge judge;
    std::optional<SnapshotRegistry::Snapshot> detectors;
    trace::TraceHash hash;
    StopConditions::State stops;
    SnapshotRegistry::Snapshot robot;
    scenario::ScenarioPlayer::Saved player;
    std::any executor;
  };
  Saved save() const;
  void restore(const Saved& saved);

 private:
  Agent(const AgentSetup& own, const Stage& stage, int number, ResolvedMission&& resolved_mission);

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  void byte_sent(std::uint8_t byte, SimTime t) override;
  void level_seen(Pin pin, bool level, SimTime t) override { state_.listener->level_seen(pin, level, t); }
  void volts_seen(Pin pin, double volts, SimTime t) override { state_.listener->volts_seen(pin, volts, t); }
  void byte_received(std::uint8_t byte, SimTime t) override { state_.listener->byte_received(byte, t); }

  void act_in_full(SimTime t);
  std::optional<judge::Verdict> verdict_at(SimTime end);
  std::optional<judge::Verdict> verdict_of_rules(std::optional<judge::Verdict> verdict, SimTime end);
  bool exceeds_budget();
  void feed_board(SimTime t);
  void put(const Pose& where);
  void look_to_the_side();
  SimTime wakes_at(SimTime end) const;
  bool is_undisturbed(SimTime end) const;
  bool is_silent(SimTime end) const { return end - executor_.last_call() >= judge::kSilentAfter; }
  bool undisturbed_tick(SimTime end, bool checks_progress);
  bool pass_places(SimTime end);
  bool evaluate_in_full(SimTime end);
  SimTime next_report(SimTime end) const;
  void measure(SimTime end);
  void sample_sensors(SimTime end);
  void watch_steering(SimTime end);
  void count_tick(SimTime end);
  void hear_parts(SimTime t);
  /// Reports the events of one step of the tick that begins at `tick`.
  void tell_events(SimTime t, SimTime tick, int step);
  /// Returns a sample that is valid until the next call.
  const Sample& sample_at(SimTime t);
  judge::Metrics metrics() const;
  judge::Evidence evidence(judge::Verdict verdict, SimTime t);

  const AgentSetup& own_;
  const Setup& setup_;
  const int number_;
  exec::Executor& executor_;
  const std::optional<exec::Crash>& crash_;  ///< the executor's crash
  const map::Start start_;
  const map::Network network_;
  const judge::Goal goal_;
  judge::Progress progress_;
  const world::World& world_;
  const std::size_t body_number_;
  world::Body& body_;
  RobotPort& board_;
  robot::Robot robot_;
  scenario::ScenarioPlayer player_;
  judge::Judge judge_;
  std::optional<detect::Detectors> detectors_;  ///< empty if detectors are off
  trace::TraceHash hash_;
  const Vec2 sensor_midpoint_;
  State state_;
  AppendOnlyText serial_;
  Sample sample_;                         ///< reused for every sample
  std::vector<robot::Reading> readings_;  ///< for sample_
  StopConditions stops_;
  std::vector<Untold>* untold_ = nullptr;
};

[[gnu::always_inline]] inline void Agent::count_tick(SimTime end) {
  if (body_.in_hand()) return;
  if (end > kSettling) {
    state_.cross_track_squares += state_.cross_track * state_.cross_track;
    if (state_.cross_track > state_.cross_track_max) state_.cross_track_max = state_.cross_track;
    ++state_.cross_track_ticks;
  }
  if (!state_.sees_line && robot_.has_line_sensors()) ++state_.off_line_ticks;
}

[[gnu::always_inline]] inline bool Agent::run_firmware(SimTime end) {
  executor_.run_until(end);
  const bool steered = robot_.end_tick(end);
  return std::exchange(state_.stirred, false) || steered;
}

inline SimTime Agent::step_or_sleep(SimTime t, SimTime wakes) {
  if (t < wakes && !body_.in_contact()) {
    robot_.begin_idle_tick(t);
    executor_.sleep_until(t + kTick);
    return wakes;
  }
  act(t);
  run_firmware(t + kTick);
  return wakes_at(t + kTick);
}

// Updates the distance from the line.
inline void Agent::measure(SimTime end) {
  const Vec2 midpoint = body_.pose().to_world(sensor_midpoint_);
  if (midpoint.x != state_.midpoint.x || midpoint.y != state_.midpoint.y) {
    state_.midpoint = midpoint;
    state_.cross_track = world_.floor().distance_to_line(midpoint, state_.line);
  }
  if (state_.cross_track > state_.shown.worst_cross_track) {
    state_.shown.worst_cross_track = state_.cross_track;
    state_.shown.worst_t = end;
    state_.shown.worst_at = body_.pose().position;
  }
}

// Returns whether only the body moved in the tick that ends at `end`, and evaluate_in_full() has no periodic
// work to do.
inline bool Agent::is_undisturbed(SimTime end) const {
  return end < state_.reports_at && !crash_ && state_.happened.empty() && !body_.in_hand() &&
         body_.collisions() == state_.collisions_told;
}

// Evaluates most ticks only in part. If the firmware is silent, evaluates in full, to detect a hang.
[[gnu::always_inline]] inline bool Agent::evaluate(SimTime end) {
  if (!is_undisturbed(end)) return evaluate_in_full(end);
  const bool checks_progress = !progress_.passes_by(body_);
  if ((checks_progress || end >= state_.senses_at) && is_silent(end)) [[unlikely]]
    return evaluate_in_full(end);
  return checks_progress ? pass_places(end) : undisturbed_tick(end, false);
}

// Does the part of evaluate_in_full() that is necessary in an undisturbed tick.
[[gnu::always_inline]] inline bool Agent::undisturbed_tick(SimTime end, bool checks_progress) {
  hash_.pose(body_.pose());
  if (checks_progress) progress_.look(body_, end, state_.happened);
  measure(end);
  if (end >= state_.senses_at) sample_sensors(end);
  count_tick(end);
  if (detectors_) [[unlikely]]
    watch_steering(end);
  if (checks_progress && !state_.happened.empty()) [[unlikely]]
    tell_events(end, end - kTick, 4);
  std::optional<judge::Verdict> verdict;
  if (checks_progress && progress_.reached()) [[unlikely]]
    verdict = judge::Verdict::reached;
  else
    verdict = judge_.look({.t = end,
                           .pose = &body_.pose(),
                           .wheel_travel_m = body_.wheel_travel(),
                           .sees_line = state_.sees_line,
                           .driven = robot_.driven(),
                           .toppled = body_.toppled() != world::Toppled::no,
                           .last_call = end});
  if (verdict) [[unlikely]]
    finish(*verdict, end);
  return verdict.has_value();
}

}  // namespace robosim::run
