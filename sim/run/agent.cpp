#include "sim/run/agent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/judge/wiring_usage.h"
#include "sim/robot/describe.h"

namespace robosim::run {
namespace {

constexpr double kFarthestSight = 1e3;  // in metres; a robot that sees this far can be affected by all others
constexpr std::size_t kEventsKept = 8;
constexpr SimTime kBudgetEvery = 100 * kMillisecond;

std::string exceeded_budget(const robot::Budget& budget, const std::optional<exec::Resources>& used) {
  if (!used) return "";
  if (budget.stack_bytes > 0 && used->stack_bytes_max > budget.stack_bytes)
    return fmt::format("its stack took {} bytes, but the robot file allows {}", used->stack_bytes_max,
                       budget.stack_bytes);
  if (budget.loop_s > 0.0 && used->loop_us_max > 1e6 * budget.loop_s)
    return fmt::format("a pass of loop() took {:.3f} ms, but the robot file allows {:.3f} ms",
                       1e-3 * used->loop_us_max, 1e3 * budget.loop_s);
  return "";
}

constexpr const char* kCannotBeSaved =
    "saving a run requires an emulated chip: firmware for the host is a program of this machine";

std::optional<exec::Resources> resources_of(exec::Executor& executor) {
  exec::ChipAccess* const chip = executor.chip_access();
  return chip ? chip->resources() : std::nullopt;
}

struct Nobody final : Listener {
  bool minds_turns() const override { return false; }
};

Listener& nobody() {
  static Nobody listener;
  return listener;
}

}  // namespace

Agent::Agent(const AgentSetup& own, const Stage& stage, int number)
    : Agent(own, stage, number,
            stage.prepared_map.resolve(static_cast<std::size_t>(number), {own.start, own.goal})) {}

Agent::Agent(const AgentSetup& own, const Stage& stage, int number, ResolvedMission&& resolved_mission)
    : own_(own),
      setup_(stage.setup),
      number_(number),
      executor_(*own.executor),
      crash_(executor_.crash()),
      start_(resolved_mission.start),
      network_(std::move(resolved_mission.network)),
      goal_(std::move(resolved_mission.goal)),
      progress_(std::move(resolved_mission.progress)),
      world_(stage.prepared_map.world()),
      body_number_(stage.prepared_map.world().add_body(
          robot::body_params(*own.robot, setup_.seed, setup_.profile, static_cast<std::uint32_t>(number)),
          stage.prepared_map.stripes().pose_of(start_))),
      body_(stage.prepared_map.world().body(body_number_)),
      board_(executor_.board()),
      robot_(*own.robot, stage.prepared_map.world(), body_number_, board_, setup_.seed, setup_.profile,
             static_cast<std::uint32_t>(number)),
      player_(own.scenario,
              {*setup_.map, stage.prepared_map.stripes(), robot_, stage.prepared_map.world(), body_,
               executor_, setup_.seed, static_cast<std::uint32_t>(number), setup_.profile},
              progress_),
      judge_(robot_.has_line_sensors()),
      sensor_midpoint_(robot_.sensor_midpoint()),
      state_{.listener = own.listener ? own.listener : &nobody()},
      stops_({serial_.text(), progress_, body_, robot_, board_, number}) {
  state_.went_high.resize(board_.spec().pin_count);
  state_.was_output.resize(board_.spec().pin_count);
  state_.was_pulled_up.resize(board_.spec().pin_count);
  for (Pin pin = 0; pin < board_.spec().pin_count; ++pin) board_.watch(pin, *this);
  board_.watch_serial(*this);
  if (state_.listener->wants_inputs()) board_.watch_inputs(*this);
  if (setup_.detect) detectors_.emplace(robot_, executor_, setup_.map->line_m);
}

// Returns false in a competition, because its rules may put the robot anywhere by a manual move.
bool Agent::may_take_turns() const {
  return !progress_.contest() && !state_.listener->minds_turns() && sight() < kFarthestSight;
}

Agent::Saved Agent::save() const {
  const exec::ChipAccess& chip = exec::chip_of(executor_, kCannotBeSaved);
  Saved saved{state_, serial_.save(), progress_,     judge_,         {},
              hash_,  stops_.save(),  robot_.save(), player_.save(), chip.save()};
  if (detectors_) saved.detectors = detectors_->save();
  return saved;
}

void Agent::restore(const Saved& saved) {
  exec::chip_of(executor_, kCannotBeSaved).restore(saved.executor);
  player_.restore(saved.player);
  robot_.restore(saved.robot);
  stops_.restore(saved.stops);
  hash_ = saved.hash;
  judge_ = saved.judge;
  if (detectors_ && saved.detectors) detectors_->restore(*saved.detectors);
  progress_ = saved.progress;
  serial_.restore(saved.serial);
  state_ = saved.own;
}

void Agent::begin() {
  const map::Map& map = *setup_.map;
  Beginning beginning{start_, goal_, network_.stations, {}, map.width, map.height, map.cell_m};
  for (const robot::Reading& reading : robot_.readings()) beginning.readings.emplace_back(reading.part);
  state_.listener->began(beginning);
  executor_.power_on(0);
  if (setup_.samples_every > 0) state_.listener->sampled(sample_at(0));
}

void Agent::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  state_.stirred = true;
  hash_.pin(pin, drive, t);
  if (drive.mode == PinMode::input_pullup) state_.was_pulled_up[pin] = true;
  if (drive.mode == PinMode::output) {
    state_.was_output[pin] = true;
    if (drive.duty > 0.0) state_.went_high[pin] = true;
  }
  if (setup_.controller) stops_.pin_changed(pin, drive);
  state_.listener->pin_changed(pin, drive, t);
}

void Agent::byte_sent(std::uint8_t byte, SimTime t) {
  hash_.serial(byte, t);
  state_.sent_at = t;
  if (serial_.text().size() < judge::kSerialKept) serial_.add(static_cast<char>(byte));
  player_.hear(byte);
  state_.listener->byte_sent(byte, t);
}

std::vector<std::uint8_t> Agent::eeprom() const {
  const auto memory = executor_.probe().memory();
  return {memory.begin(), memory.end()};
}

void Agent::hear_parts(SimTime t) {
  std::vector<robot::PartText> told;
  robot_.poll_text(t, told);
  for (robot::PartText& one : told) {
    player_.hear(one);
    state_.happened.push_back(result::PartTold{std::move(one.part), std::move(one.text)});
  }
}

void Agent::tell_events(SimTime t, SimTime tick, int step) {
  for (result::RunEvent::What& what : state_.happened) {
    const bool shows = std::holds_alternative<result::PartTold>(what);
    state_.events.push_back({t, number_, std::move(what)});
    if (shows && state_.told.size() < judge::kShownKept)
      state_.told += result::text_of(state_.events.back()) + '\n';
    if (untold_)
      untold_->push_back({tick, step, number_, state_.listener, state_.events.back()});
    else
      state_.listener->happened(state_.events.back());
    if (setup_.controller) stops_.happened(state_.events.back());
    if (state_.events.size() > kEventsKept) state_.events.pop_front();
  }
  state_.happened.clear();
}

void Agent::look_to_the_side() {
  // kAside, in m: smaller lateral offsets of the line are ignored. kShare: weight of each check in the mean.
  constexpr double kAside = 0.002, kShare = 0.1;
  const double side = robot_.line_side();
  if (std::abs(side) < kAside) return;
  const double left = robot_.right_command() - robot_.left_command();
  // A command that was given before the line came to this side is not a response to the line.
  if (side * state_.line_side <= 0.0) {
    state_.side_command = left;
    state_.steered = 0.0;
  }
  state_.line_side = side;
  const double towards = side > 0.0 ? left : -left;
  if (left == state_.side_command && towards <= 0.0) return;
  state_.steered += kShare * (towards - state_.steered);
}

// Reads the sensors that are due. Does nothing if called too early.
void Agent::sample_sensors(SimTime end) {
  const DueChecks& due = checks_at(end);
  if (due.at_sensors) state_.sees_line = robot_.sees_line() || robot_.straddles_line(state_.cross_track);
  if (state_.sees_line && due.aside) look_to_the_side();
  state_.senses_at = end + due.next * kTick;
}

void Agent::watch_steering(SimTime end) {
  detectors_->look({end, state_.sent_at, body_.distance(), body_.wheel_travel(), robot_.left_command(),
                    robot_.right_command(), state_.sees_line, player_.powered() && !body_.in_hand()});
}

const Sample& Agent::sample_at(SimTime t) {
  Sample& sample = sample_;
  sample.t = t;
  sample.pose = body_.pose();
  sample.speed = body_.speed();
  sample.cross_track = state_.cross_track;
  sample.left = robot_.left_command(), sample.right = robot_.right_command();
  sample.wheels = {body_.tread_speed(world::left), body_.tread_speed(world::right)};
  sample.at_station.clear();
  readings_.clear();
  robot_.read(readings_);
  sample.readings.resize(readings_.size());
  std::transform(readings_.begin(), readings_.end(), sample.readings.begin(),
                 [](const robot::Reading& reading) { return reading.value; });
  if (setup_.controller) {
    for (const judge::Waypoint& station : progress_.stations())
      if (body_.covers(station.centre)) sample.at_station = station.name;
  }
  return sample;
}

void Agent::begin_leg(const Leg& leg, SimTime t) {
  stops_.begin(leg, t);
  state_.shown.worst_cross_track = 0.0;
  state_.shown.worst_t = t;
  state_.shown.worst_at = body_.pose().position;
}

void Agent::publish_pause_state(SimTime t, int stop_met) {
  run::State& shown = state_.shown;
  shown.t = t;
  shown.stop = stop_met;
  shown.powered = player_.powered();
  shown.driven = robot_.driven();
  shown.serial_bytes = serial_.text().size();
  shown.metrics = finished() ? state_.outcome->metrics : metrics();
  shown.resources = finished() ? state_.outcome->resources : resources_of(executor_);
  state_.sample = sample_at(t);
}

void Agent::feed_board(SimTime t) {
  if (const auto volts = robot_.fed_volts()) player_.feed(*volts, t, state_.happened);
}

void Agent::act_in_full(SimTime t) {
  if (robot_.has_battery()) feed_board(t);
  if (!finished()) player_.act(t, progress_, state_.happened);
  if (!state_.happened.empty()) tell_events(t, t, 1);  // reports causes before their effects in this tick
  if (detectors_) detectors_->booted(player_.boots());
  robot_.begin_tick(t);
}

SimTime Agent::wakes_at(SimTime end) const {
  if (finished()) return 0;
  const SimTime wakes = executor_.sleeps_until() - kTick + 1;
  return wakes > end && robot_.idles() ? std::min(wakes, player_.next_act(end)) : 0;
}

bool Agent::exceeds_budget() {
  state_.exceeded = exceeded_budget(own_.robot->budget, resources_of(executor_));
  return !state_.exceeded.empty();
}

inline std::optional<judge::Verdict> Agent::verdict_at(SimTime end) {
  if (progress_.reached()) return judge::Verdict::reached;
  if (crash_) return judge::Verdict::crashed;
  if (end % kBudgetEvery == 0 && exceeds_budget()) return judge::Verdict::over_budget;
  const bool powered = player_.powered();
  judge::Situation now{end,
                       &body_.pose(),
                       body_.wheel_travel(),
                       state_.sees_line,
                       robot_.driven(),
                       body_.in_contact(),
                       body_.in_hand(),
                       body_.toppled() != world::Toppled::no,
                       powered,
                       powered ? executor_.last_call() : end};
  now.hangs = end - now.last_call >= judge::kSilentAfter && executor_.hangs();
  const std::optional<judge::Verdict> verdict = judge_.look(now);
  return progress_.contest() ? verdict_of_rules(verdict, end) : verdict;
}

// A separate function, so that ticks that do not call it need no stack frame.
bool Agent::pass_places(SimTime end) { return undisturbed_tick(end, true); }

bool Agent::evaluate_in_full(SimTime end) {
  hash_.pose(body_.pose());
  progress_.update(body_, end, state_.happened);
  measure(end);
  sample_sensors(end);
  count_tick(end);
  if (body_.collisions() > state_.collisions_told) {
    state_.collisions_told = body_.collisions();
    state_.happened.push_back(result::CollisionBegan{body_.collided_with_body()});
  }
  if (detectors_) watch_steering(end);
  if (robot_.has_text_outputs()) hear_parts(end);
  if (!state_.happened.empty()) tell_events(end, end - kTick, 4);
  if (setup_.samples_every > 0 && end % setup_.samples_every == 0) {
    if (untold_)
      untold_->push_back({end - kTick, 4, number_, state_.listener, sample_at(end)});
    else
      state_.listener->sampled(sample_at(end));
  }
  const std::optional<judge::Verdict> verdict = verdict_at(end);
  if (verdict) finish(*verdict, end);
  state_.reports_at = next_report(end);
  return verdict.has_value();
}

// Returns the time by which the next full evaluation is due; 0 = in every tick.
inline SimTime Agent::next_report(SimTime end) const {
  if (robot_.has_text_outputs() || progress_.contest()) return 0;
  const auto after = [end](SimTime every) { return end - end % every + every; };
  const SimTime next = after(kBudgetEvery), every = setup_.samples_every;
  return every > 0 ? std::min(next, after(every)) : next;
}

// Applies the competition's rules to a verdict. Returns nullopt if the competition continues.
std::optional<judge::Verdict> Agent::verdict_of_rules(std::optional<judge::Verdict> verdict, SimTime end) {
  const bool needs_hand = verdict == judge::Verdict::lost || verdict == judge::Verdict::stuck ||
                          verdict == judge::Verdict::toppled;
  if (needs_hand && progress_.contest().give_up(state_.happened)) verdict.reset();
  if (const auto where = progress_.contest().take_hand()) put(*where);
  if (!state_.happened.empty()) tell_events(end, end - kTick, 4);
  if (!verdict && progress_.contest().over(end)) return judge::Verdict::timeout;
  return verdict;
}

// Moves the robot manually to `where`, as the goal's rules require.
void Agent::put(const Pose& where) {
  body_.place(where);
  state_.sees_line = true;
}

void Agent::time_out(SimTime limit) {
  finish(goal_.kind == judge::Goal::Kind::none ? judge::Verdict::reached : judge::Verdict::timeout, limit);
}

void Agent::detach(SimTime t) {
  state_.listener = &nobody();
  if (player_.powered()) executor_.power_off(t);
}

judge::Metrics Agent::metrics() const {
  judge::Metrics m;
  m.distance_m = body_.distance();
  m.laps_s = progress_.laps_s();
  if (state_.cross_track_ticks > 0)
    m.cross_track_rms_mm =
        1e3 * std::sqrt(state_.cross_track_squares / static_cast<double>(state_.cross_track_ticks));
  m.cross_track_max_mm = 1e3 * state_.cross_track_max;
  m.off_line_s = 1e-9 * static_cast<double>(state_.off_line_ticks * kTick);
  m.collisions = body_.collisions();
  m.energy_j = body_.energy();
  m.energy_back_j = body_.energy_back();
  for (const int i : progress_.visited())
    m.stations.push_back(progress_.stations()[static_cast<std::size_t>(i)].name);
  m.junctions = progress_.junctions_visited();
  progress_.score(m);
  return m;
}

void Agent::finish(judge::Verdict verdict, SimTime t) {
  const judge::Evidence e = evidence(verdict, t);
  if (setup_.controller && setup_.samples_every > 0 && t % setup_.samples_every != 0)
    state_.listener->sampled(sample_at(t));
  judge::Outcome& outcome = state_.outcome.emplace();
  outcome.verdict = verdict;
  outcome.why = explain(e);
  outcome.next = next_step(e);
  outcome.decisive = decisive_moment(e);
  outcome.goal = goal_;
  outcome.time = t;
  outcome.crash = e.crash;
  outcome.divisions_by_zero = e.divisions_by_zero;
  outcome.watchdog_resets = executor_.watchdog_resets();
  if (const exec::HostAccess* const host = executor_.host_access()) outcome.lacks = host->lacks();
  if (detectors_) outcome.detected = detectors_->found(t);
  outcome.resources = resources_of(executor_);
  outcome.usage = judge::usage_of(board_.spec(), e.wiring, state_.was_output, executor_.probe(), e.t);
  outcome.events.assign(state_.events.begin(), state_.events.end());
  outcome.serial = serial_.text();
  outcome.shown = state_.told;
  outcome.end = body_.pose();
  outcome.eeprom_writes = player_.eeprom_writes();
  outcome.trace_hash = hash_.text();
  outcome.metrics = metrics();
}

}  // namespace robosim::run
