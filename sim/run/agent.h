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

#include "sim/judge/explain.h"
#include "sim/judge/judge.h"
#include "sim/judge/steering_detectors.h"
#include "sim/run/board_detectors.h"
#include "sim/run/kept_text.h"
#include "sim/run/looks.h"
#include "sim/run/scenery.h"
#include "sim/run/simulation.h"
#include "sim/run/stop_conditions.h"
#include "sim/scenario/scenario_player.h"
#include "sim/trace/trace_hash.h"
#include "sim/world/world.h"

namespace robosim::run {

constexpr SimTime kSettling = 500 * kMillisecond;  ///< not counted in the cross-track error

class Agent final : PinWatcher, SerialWatcher, InputWatcher {
 public:
  /// What all agents of a simulation share.
  struct Stage {
    const Setup& setup;
    Scenery& scenery;
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
  void act(SimTime t) {
    if (robot_.has_battery() || board_detectors_ || player_.next_act(t) <= t || !state_.happened.empty())
        [[unlikely]]
      act_in_full(t);
    else
      robot_.begin_tick(t);
  }
  /// 2 and 3: the firmware runs to `end`, and motors get their commands. Whether anything has happened since
  /// the last time that world or judge could notice.
  bool run_firmware(SimTime end);
  /// 1 to 3, of the tick at `t`, and the time from which they have something to do again: they do not before
  /// `wakes`, as this told in the tick before (0: it is not known).
  SimTime go(SimTime t, SimTime wakes);
  /// 4: goal and judge look at the world at `end`. Whether that gave a verdict: the agent is then finished.
  bool look(SimTime end);

  // --- turns of several ticks, while it is apart from others ---
  /// What is to be told in the order of time, once all have come as far.
  struct Untold {
    SimTime tick;  ///< when that began
    int step;      ///< of the tick, as above
    int agent;
    Listener* listener;
    std::variant<wire::RunEvent, Sample> what;
  };
  /// Whether it may ever take turns.
  bool may_take_turns() const;
  double sight() const { return robot_.sight(); }
  /// When its script does something next; kNever if it has its verdict.
  SimTime acts_at(SimTime t) const { return finished() ? kNever : player_.next_act(t); }
  /// Its events and samples are added there from now on, instead of being told; null: they are told.
  void tell_later(std::vector<Untold>* untold) { untold_ = untold; }

  // --- ticks of a robot at rest (resting.cpp) ---
  /// Whether act(), but for its parts, and look() would find the same again in the ticks that begin between
  /// `end` and the time that this returns, as long as the world is still and nothing happens: look() has just
  /// been asked at `end`. `end`: none.
  SimTime rests_until(SimTime end) const;
  /// 1, in such a tick.
  void begin_rest(SimTime t) {
    if (board_detectors_) board_detectors_->booted(player_.boots());
    robot_.begin_tick(t);
  }
  bool has_crashed() const { return crash_.has_value(); }
  /// 4, at the end of one.
  void rest(SimTime end);
  /// Behind such ticks, before anything else happens at `t`: as if it had looked all the time.
  void catch_up(SimTime t);

  /// Ends its run with this verdict.
  void finish(judge::Verdict verdict, SimTime t);
  /// Its time is up: reached where there was no goal.
  void time_out(SimTime limit);
  bool finished() const { return state_.outcome.has_value(); }
  /// Leaves a finished agent on the floor while others go on: the firmware is off, and nothing is told any
  /// more.
  void leave(SimTime t);
  const judge::Outcome* outcome() const { return finished() ? &*state_.outcome : nullptr; }
  judge::Outcome take_outcome() { return std::move(*state_.outcome); }

  // --- driven step by step (step_controller.h) ---
  void begin_leg(const Leg& leg, SimTime t);
  /// At the end of a tick: whether the leg ends here. met() then says which stop did it, or -1.
  bool leg_ends(SimTime t) { return stops_.look(t); }
  int met() const { return stops_.met(); }
  void check(const Leg& leg) const { stops_.check(leg); }
  void add(std::vector<scenario::Step> steps) { player_.add(std::move(steps), progress_); }
  /// Its state where the run stands still at `t`; stop_met: of all agents.
  void stand_still(SimTime t, int stop_met);
  const run::State& state() const { return state_.shown; }
  const Sample& sample() const { return state_.sample; }
  std::vector<std::uint8_t> eeprom() const;

  // --- snapshots (simulation.h) ---
  struct State {
    Listener* listener;                                               ///< nobody, once the agent has left
    std::string exceeded;                                             ///< the budget that was, as a sentence
    Vec2 midpoint = {std::numeric_limits<double>::quiet_NaN(), 0.0};  ///< of the sensors, where they were
    double cross_track = 0.0;                                         ///< there
    world::NearStripe line;                                           ///< near to it
    double cross_track_squares = 0.0;
    double cross_track_max = 0.0;
    std::int64_t cross_track_ticks = 0;
    std::int64_t off_line_ticks = 0;
    bool sees_line = true;
    double line_side = 0.0;  ///< Robot::line_side(), when it was last seen to a side
    double steered = 0.0;  ///< then: how it steered towards it, -2..2, a running mean; below 0: away from it
    int collisions_told = 0;
    SimTime senses_at = 0;   ///< until then no sensor is looked at
    SimTime reports_at = 0;  ///< until then there is nothing else to do now and then: see is_undisturbed()
    bool stirred = false;    ///< a pin has changed since the tick began
    judge::Events happened;  ///< in this tick
    std::deque<wire::RunEvent> events;
    SimTime sent_at = -1;  ///< when its last byte was
    std::string told;      ///< what parts have told, a line each
    run::State shown;
    Sample sample;
    std::vector<bool> went_high, was_output, was_pulled_up;
    std::optional<judge::Outcome> outcome;
  };
  /// All that changes during a run, but for its body.
  struct Saved {
    State own;
    KeptText::Copy serial;
    judge::Progress progress;
    judge::Judge judge;
    std::optional<judge::SteeringDetectors> steering;
    std::optional<BoardDetectors::State> board_detectors;
    trace::TraceHash hash;
    StopConditions::State stops;
    Kept::Copy robot;
    scenario::ScenarioPlayer::Saved player;
    std::any executor;
  };
  Saved save() const;
  void restore(const Saved& saved);

 private:
  Agent(const AgentSetup& own, const Stage& stage, int number, Task&& task);

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
  bool pass(SimTime end, bool checks_progress);
  bool pass_places(SimTime end);
  bool look_closely(SimTime end);
  SimTime next_report(SimTime end) const;
  void measure(SimTime end);
  void sense(SimTime end);
  void watch_steering(SimTime end);
  std::vector<exec::Detected> detected(SimTime t) const;
  void count_tick(SimTime end);
  void hear_parts(SimTime t);
  /// Of a step, as above, of the tick that begins at `tick`.
  void tell_events(SimTime t, SimTime tick, int step);
  /// Until the next call.
  const Sample& sample_at(SimTime t);
  judge::Metrics metrics() const;
  judge::Evidence evidence(judge::Verdict verdict, SimTime t);

  const AgentSetup& own_;
  const Setup& setup_;
  const int number_;
  exec::Executor& executor_;
  const std::optional<exec::Crash>& crash_;  ///< the executor's
  const grid::Start start_;
  const grid::Network network_;
  const judge::Goal goal_;
  judge::Progress progress_;
  const world::World& world_;
  const std::size_t body_number_;
  world::Body& body_;
  RobotPort& board_;
  robot::Robot robot_;
  scenario::ScenarioPlayer player_;
  judge::Judge judge_;
  std::optional<judge::SteeringDetectors> steering_;  ///< nothing = nobody asks
  std::optional<BoardDetectors> board_detectors_;     ///< the same
  trace::TraceHash hash_;
  const Vec2 sensor_midpoint_;
  State state_;
  KeptText serial_;
  Sample sample_;                         ///< made again and again
  std::vector<robot::Reading> readings_;  ///< for it
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

inline SimTime Agent::go(SimTime t, SimTime wakes) {
  if (t < wakes && !body_.in_contact()) {
    robot_.begin_idle_tick(t);
    executor_.sleep_until(t + kTick);
    return wakes;
  }
  act(t);
  run_firmware(t + kTick);
  return wakes_at(t + kTick);
}

// The distance from the line.
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

// Whether nothing has happened in the tick that ends at `end` but that the body has gone on, and it is no
// time for what look_closely() does now and then.
inline bool Agent::is_undisturbed(SimTime end) const {
  return end < state_.reports_at && !crash_ && state_.happened.empty() && !body_.in_hand() &&
         body_.collisions() == state_.collisions_told;
}

// Most ticks are undisturbed. Whether firmware hangs is asked where something is looked at.
[[gnu::always_inline]] inline bool Agent::look(SimTime end) {
  if (!is_undisturbed(end)) return look_closely(end);
  const bool checks_progress = !progress_.passes_by(body_);
  if ((checks_progress || end >= state_.senses_at) && is_silent(end)) [[unlikely]]
    return look_closely(end);
  return checks_progress ? pass_places(end) : pass(end, false);
}

// All that look_closely() does in an undisturbed tick.
[[gnu::always_inline]] inline bool Agent::pass(SimTime end, bool checks_progress) {
  hash_.pose(body_.pose());
  if (checks_progress) progress_.look(body_, end, state_.happened);
  measure(end);
  if (end >= state_.senses_at) sense(end);
  count_tick(end);
  if (steering_) [[unlikely]]
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
