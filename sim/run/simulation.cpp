#include "sim/run/simulation.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>

#include "hal/board/board_spec.h"
#include "sim/judge/explain.h"
#include "sim/judge/judge.h"
#include "sim/robot/describe.h"
#include "sim/run/stop_conditions.h"
#include "sim/scenario/scenario_player.h"
#include "sim/trace/trace_hash.h"
#include "sim/world/world.h"

namespace robosim::run {
namespace {

constexpr SimTime kSettling = 500 * kMillisecond;  // not counted in the cross-track error
constexpr int kLookEvery = 4;                      // ticks between two looks at all sensors
constexpr std::size_t kEventsKept = 8;
constexpr SimTime kBudgetEvery = 100 * kMillisecond;

std::string exceeded_budget(const robot::Budget& budget, const std::optional<exec::Resources>& used) {
  if (!used) return "";
  if (budget.stack_bytes > 0 && used->stack_bytes_max > budget.stack_bytes)
    return fmt::format("its stack took {} bytes; the robot file allows {}", used->stack_bytes_max,
                       budget.stack_bytes);
  if (budget.loop_s > 0.0 && used->loop_us_max > 1e6 * budget.loop_s)
    return fmt::format("a pass of loop() took {:.3f} ms; the robot file allows {:.3f} ms",
                       1e-3 * used->loop_us_max, 1e3 * budget.loop_s);
  return "";
}

/// Everything of one run. Built in the order in which things depend on each other.
class Simulation final : PinWatcher, SerialWatcher, InputWatcher, Standstill {
 public:
  Simulation(const Setup& setup, Listener& listener);
  judge::Outcome run();

 private:
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  void byte_sent(std::uint8_t byte, SimTime t) override;
  void level_seen(Pin pin, bool level, SimTime t) override { listener_.level_seen(pin, level, t); }
  void volts_seen(Pin pin, double volts, SimTime t) override { listener_.volts_seen(pin, volts, t); }
  void byte_received(std::uint8_t byte, SimTime t) override { listener_.byte_received(byte, t); }

  const State& state() const override { return state_; }
  const Sample& sample() const override { return sample_; }
  std::vector<std::uint8_t> eeprom() const override {
    return {board_.eeprom(), board_.eeprom() + board_.spec().eeprom_bytes};
  }
  void add(std::vector<scenario::Step> steps) override { player_.add(std::move(steps), progress_); }
  void check(const Leg& leg) const override { stops_.check(leg); }

  bool stand_still(SimTime t);
  std::optional<judge::Verdict> tick(SimTime t);
  void observe(SimTime end);
  void note(SimTime t);
  Sample sample_at(SimTime t) const;
  judge::Metrics metrics() const;
  judge::Outcome finish(judge::Verdict verdict, SimTime t);
  judge::Evidence evidence(judge::Verdict verdict, SimTime t);

  const Setup& setup_;
  Listener& listener_;
  const grid::Map& map_;
  grid::Start start_;
  grid::Network network_;
  grid::Stripes stripes_;
  judge::Goal goal_;
  judge::Progress progress_;
  world::World world_;
  world::Body& body_;
  Board& board_;
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
  int collisions_noted_ = 0;
  std::vector<std::string> notes_;
  std::deque<judge::Event> events_;
  std::string serial_;
  StopConditions stops_;
  State state_;
  Sample sample_;
  std::vector<bool> went_high_ = std::vector<bool>(kMaxPins);
  std::vector<bool> was_output_ = std::vector<bool>(kMaxPins);
};

grid::Stripes stripes_of(const grid::Map& map) { return grid::Stripes(map, map.cell_m); }

Simulation::Simulation(const Setup& setup, Listener& listener)
    : setup_(setup),
      listener_(listener),
      map_(*setup.map),
      start_(setup.start ? *setup.start : grid::default_start(map_)),
      network_(grid::trace_network(map_, start_)),
      stripes_(stripes_of(map_)),
      goal_(setup.goal ? *setup.goal : judge::default_goal(map_, network_)),
      progress_(goal_, map_, stripes_, network_, start_),
      world_(map_),
      body_(world_.body(world_.add_body(robot::body_params(*setup.robot, setup.seed, setup.profile),
                                        {stripes_.point_of(start_.cell), grid::heading(start_.facing)}))),
      board_(setup.executor->board()),
      robot_(*setup.robot, world_, 0, board_, setup.seed, setup.profile),
      player_(setup.scenario, {map_, stripes_, robot_, world_, body_, *setup.executor, setup.seed},
              progress_),
      judge_(robot_.has_line_sensors()),
      sensor_midpoint_(robot_.sensor_midpoint()),
      stops_({serial_, progress_, body_, robot_, board_}) {
  for (Pin pin = 0; pin < board_.spec().pin_count; ++pin) board_.watch(pin, *this);
  board_.watch_serial(*this);
  if (listener_.wants_inputs()) board_.watch_inputs(*this);
}

void Simulation::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  hash_.pin(pin, drive, t);
  if (drive.mode == PinMode::output) {
    was_output_[pin] = true;
    if (drive.duty > 0.0) went_high_[pin] = true;
  }
  if (setup_.controller) stops_.pin_changed(pin, drive);
  listener_.pin_changed(pin, drive, t);
}

void Simulation::byte_sent(std::uint8_t byte, SimTime t) {
  hash_.serial(byte, t);
  if (serial_.size() < judge::kSerialKept) serial_ += static_cast<char>(byte);
  player_.hear(byte);
  listener_.byte_sent(byte, t);
}

void Simulation::note(SimTime t) {
  for (std::string& text : notes_) {
    events_.push_back({t, std::move(text)});
    listener_.noted(events_.back());
    if (setup_.controller) stops_.noted(events_.back().text);
    if (events_.size() > kEventsKept) events_.pop_front();
  }
  notes_.clear();
}

void Simulation::observe(SimTime end) {
  cross_track_ = world_.floor().distance_to_line(body_.pose().to_world(sensor_midpoint_));
  if (end > kSettling) {
    cross_track_squares_ += cross_track_ * cross_track_;
    if (cross_track_ > cross_track_max_) cross_track_max_ = cross_track_;
    ++cross_track_ticks_;
  }
  if (cross_track_ > state_.worst_cross_track) {
    state_.worst_cross_track = cross_track_;
    state_.worst_t = end;
    state_.worst_at = body_.pose().position;
  }
  if (end / kTick % kLookEvery == 0) sees_line_ = robot_.sees_line();
  if (!sees_line_ && !body_.lifted()) ++off_line_ticks_;
  if (body_.collisions() > collisions_noted_) {
    collisions_noted_ = body_.collisions();
    notes_.push_back("collision with a wall, an obstacle or the map's edge");
  }
}

Sample Simulation::sample_at(SimTime t) const {
  Sample sample{t, body_.pose(), body_.speed(), cross_track_, robot_.left_command(), robot_.right_command(),
                {}};
  for (const robot::Reading& reading : robot_.readings()) sample.readings.push_back(reading.value);
  if (setup_.controller) {
    for (const judge::Target& station : progress_.stations())
      if (body_.covers(station.centre)) sample.at_station = station.name;
  }
  return sample;
}

// The controller's turn. False if the run is to end here.
bool Simulation::stand_still(SimTime t) {
  state_.t = t;
  state_.stop = stops_.met();
  state_.powered = player_.powered();
  state_.driven = robot_.driven();
  state_.serial_bytes = serial_.size();
  state_.metrics = metrics();
  state_.resources = setup_.executor->resources();
  sample_ = sample_at(t);
  const Leg leg = setup_.controller->next(*this);
  if (leg.end) return false;
  stops_.begin(leg, t);
  state_.worst_cross_track = 0.0;
  state_.worst_t = t;
  state_.worst_at = body_.pose().position;
  return true;
}

std::optional<judge::Verdict> Simulation::tick(SimTime t) {
  const SimTime end = t + kTick;
  exec::Executor& executor = *setup_.executor;
  player_.act(t, progress_, notes_);
  robot_.begin_tick(t);
  executor.run_until(end);
  robot_.end_tick(end);
  world_.step();
  hash_.pose(body_.pose());

  progress_.update(body_, end, notes_);
  observe(end);
  if (!notes_.empty()) note(end);
  if (setup_.samples_every > 0 && end % setup_.samples_every == 0) listener_.sampled(sample_at(end));

  if (progress_.reached()) return judge::Verdict::reached;
  if (executor.crash()) return judge::Verdict::crashed;
  if (end % kBudgetEvery == 0) {
    exceeded_ = exceeded_budget(setup_.robot->budget, executor.resources());
    if (!exceeded_.empty()) return judge::Verdict::over_budget;
  }
  judge::Situation now{end,
                       &body_.pose(),
                       body_.wheel_travel(),
                       sees_line_,
                       robot_.driven(),
                       body_.lifted(),
                       player_.powered(),
                       player_.powered() ? executor.last_call() : end};
  return judge_.look(now);
}

judge::Outcome Simulation::run() {
  Beginning beginning{start_, goal_, network_.stations, {}, map_.width, map_.height, map_.cell_m};
  for (const robot::Reading& reading : robot_.readings()) beginning.readings.push_back(reading.part);
  listener_.began(beginning);
  setup_.executor->power_on(0);
  if (setup_.samples_every > 0) listener_.sampled(sample_at(0));
  bool leg_over = true;
  for (SimTime t = 0; t < setup_.limit; t += kTick) {
    if (setup_.controller && leg_over && !stand_still(t)) return finish(judge::Verdict::interrupted, t);
    if (setup_.reached) setup_.reached->store(t, std::memory_order_relaxed);
    if (const auto verdict = tick(t)) return finish(*verdict, t + kTick);
    if (setup_.interrupted && setup_.interrupted->load(std::memory_order_relaxed))
      return finish(judge::Verdict::interrupted, t + kTick);
    leg_over = setup_.controller && stops_.look(t + kTick);
  }
  return finish(goal_.kind == judge::Goal::Kind::none ? judge::Verdict::reached : judge::Verdict::timeout,
                setup_.limit);
}

judge::Evidence Simulation::evidence(judge::Verdict verdict, SimTime t) {
  judge::Evidence e;
  e.verdict = verdict;
  e.t = t;
  e.limit = setup_.limit;
  e.map = &map_;
  e.goal = &goal_;
  e.progress = &progress_;
  e.judge = &judge_;
  e.crash = setup_.executor->crash();
  e.exceeded = exceeded_;
  e.int_bits = setup_.executor->int_bits();
  e.wiring = robot_.wiring();
  e.went_high = went_high_;
  e.was_output = was_output_;
  e.in_contact = body_.in_contact();
  e.moved = body_.wheel_travel() > 0.0;
  if (verdict != judge::Verdict::reached) e.activity = setup_.executor->activity();
  const Pin looked_at = e.activity.polled != kNoPin ? e.activity.polled : e.activity.pin;
  if (looked_at != kNoPin) e.pin_level = board_.read_level(looked_at, t);
  return e;
}

judge::Metrics Simulation::metrics() const {
  judge::Metrics m;
  m.distance_m = body_.distance();
  m.laps_s = progress_.laps_s();
  if (cross_track_ticks_ > 0)
    m.cross_track_rms_mm = 1e3 * std::sqrt(cross_track_squares_ / static_cast<double>(cross_track_ticks_));
  m.cross_track_max_mm = 1e3 * cross_track_max_;
  m.off_line_s = 1e-9 * static_cast<double>(off_line_ticks_ * kTick);
  m.collisions = body_.collisions();
  m.energy_j = body_.energy();
  for (const int i : progress_.visited())
    m.stations.push_back(progress_.stations()[static_cast<std::size_t>(i)].name);
  m.junctions = progress_.junctions_visited();
  return m;
}

judge::Outcome Simulation::finish(judge::Verdict verdict, SimTime t) {
  const judge::Evidence e = evidence(verdict, t);
  if (setup_.controller && setup_.samples_every > 0 && t % setup_.samples_every != 0)
    listener_.sampled(sample_at(t));
  judge::Outcome outcome;
  outcome.verdict = verdict;
  outcome.why = explain(e);
  outcome.next = next_step(e);
  outcome.goal = goal_;
  outcome.time = t;
  outcome.crash = e.crash;
  outcome.resources = setup_.executor->resources();
  outcome.events.assign(events_.begin(), events_.end());
  outcome.serial = std::move(serial_);
  outcome.end = body_.pose();
  outcome.eeprom_writes = player_.eeprom_writes();
  outcome.trace_hash = hash_.text();

  outcome.metrics = metrics();
  return outcome;
}

}  // namespace

judge::Outcome simulate(const Setup& setup, Listener& listener) { return Simulation(setup, listener).run(); }

}  // namespace robosim::run
