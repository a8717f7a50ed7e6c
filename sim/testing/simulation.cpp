#include "robosim/testing/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "sim/base/error.h"
#include "sim/client/driven_run.h"
#include "sim/testing/artifacts.h"
#include "sim/testing/coverage.h"
#include "sim/testing/rehearsal.h"
#include "sim/testing/reports.h"
#include "sim/testing/run_log.h"
#include "sim/testing/stage.h"

namespace robosim::testing {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

bool is_failure(const std::string& verdict) {
  return verdict == "lost" || verdict == "stuck" || verdict == "toppled" || verdict == "hung" ||
         verdict == "crashed" || verdict == "over_budget";
}

/// Up to the next whole tick.
std::int64_t in_ticks(Duration time) {
  return (time.count() + kMillisecond_ns - 1) / kMillisecond_ns * kMillisecond_ns;
}

std::string ms(Duration time) { return std::to_string(in_ticks(time) / kMillisecond_ns) + "ms"; }

}  // namespace

struct Simulation::Inside {
  explicit Inside(const Trial& trial);

  void take(const wire::Event& event);
  void go_on(std::int64_t to_ns, const std::vector<wire::Stop>& stops);
  void look();
  void read_on(const Event::One& event);
  wire::Stop stop_for(const Event::One& event) const;
  Drive drive(std::int64_t begin_ns) const { return Drive(log, Duration(begin_ns), Duration(now_ns())); }
  std::int64_t now_ns() const { return log->legs.empty() ? 0 : log->legs.back().end_ns; }

  std::shared_ptr<RunLog> log = std::make_shared<RunLog>();
  Borrowed runner;
  Stage stage;
  std::unique_ptr<client::DrivenRun> run;
  std::size_t read = 0;  ///< bytes of the serial text that are done with
  const char* ended_file = nullptr;
  int ended_line = 0;
};

Simulation::Inside::Inside(const Trial& trial) : runner(trial.target), stage(set_stage(trial, *runner)) {
  log->trial = trial;
  log->sketch_name = stage.sketch_title;
  log->map_name = stage.map_is_text ? "the test's map" : std::filesystem::path(stage.map).stem().string();
  log->robot_name = stage.robot_is_text ? "the test's robot" : stage.robot.name;
  log->artifacts = artifact_folder();
  log->replay = robosim::testing::replay_command(stage, log->artifacts, !trial.script.empty());
  run = std::make_unique<client::DrivenRun>(*runner, stage.request,
                                            [this](const wire::Event& event) { take(event); });
  log->samples.push_back(run->state().sample);
  log->resources = run->state().resources;
  for (const std::string& reading : log->started.readings) {
    const auto& sensors = stage.robot.sensors;
    log->is_line_sensor.push_back(std::any_of(sensors.begin(), sensors.end(),
                                              [&](const auto& sensor) { return sensor.name == reading; }));
  }
}

void Simulation::Inside::take(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event)) log->started = *started;
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    if (log->samples.empty() || log->samples.back().t_us < sample->t_us) log->samples.push_back(*sample);
  }
  if (const auto* note = std::get_if<wire::Note>(&event))
    log->add({note->t_ns, on_one_line(note->text), note->is<wire::CollisionBegan>() != nullptr});
  if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    log->serial += serial->text;
    log->said.push_back({serial->t_ns, log->serial.size()});
    log->add({serial->t_ns, "the sketch says " + in_quotes(serial->text)});
  }
}

void Simulation::Inside::go_on(std::int64_t to_ns, const std::vector<wire::Stop>& stops) {
  RunLog::Leg leg;
  leg.begin_ns = now_ns();
  try {
    if (to_ns < 0)
      run->finish();
    else
      run->go_on(to_ns, stops);
  } catch (const wire::RunnerError&) {
    runner.condemn();
    throw;
  }
  if (run->over()) {
    log->result = run->result();
    leg.end_ns =
        std::max<std::int64_t>(leg.begin_ns, std::llround(run->result().time_s * 1e3) * kMillisecond_ns);
    leg.at_end = run->result().metrics;
    log->resources = run->result().resources;
    for (const wire::Sample& sample : log->samples) {
      if (sample.t_us * 1000 < leg.begin_ns || sample.cross_track_mm < leg.worst_mm) continue;
      leg.worst_mm = sample.cross_track_mm;
      leg.worst_ns = sample.t_us * 1000;
      leg.worst_x_mm = sample.x_mm;
      leg.worst_y_mm = sample.y_mm;
    }
  } else {
    const wire::Paused& state = run->state();
    leg.end_ns = state.t_ns;
    leg.worst_mm = state.worst.cross_track_mm;
    leg.worst_ns = state.worst.t_ns;
    leg.worst_x_mm = state.worst.x_mm;
    leg.worst_y_mm = state.worst.y_mm;
    leg.at_end = state.metrics;
    log->resources = state.resources;
    if (log->samples.back().t_us < state.sample.t_us) log->samples.push_back(state.sample);
  }
  log->legs.push_back(std::move(leg));
}

wire::Stop Simulation::Inside::stop_for(const Event::One& event) const {
  using Kind = Event::Kind;
  switch (event.kind) {
    case Kind::serial:
      return wire::Stop::serial(event.text, read);
    case Kind::line:
      return wire::Stop::line(event.text, read);
    case Kind::note:
      return wire::Stop::note(event.text);
    case Kind::event:
      return wire::Stop::event(event.text);
    case Kind::visited:
      return wire::Stop::visited(event.text);
    case Kind::at:
      return wire::Stop::at(event.text);
    case Kind::reading:
      return wire::Stop::reading(event.text, event.level);
    case Kind::pin:
      return wire::Stop::pin(event.text, event.level);
    case Kind::motors:
      return wire::Stop::motors(event.level);
    case Kind::rest:
    case Kind::end:
      return wire::Stop::rest(event.time.count());
  }
  return {};
}

// What comes next is looked for behind the text that was just found.
void Simulation::Inside::read_on(const Event::One& event) {
  const std::string& text = log->serial;
  const std::size_t all = run->state().serial_bytes;
  const std::size_t from = text.size() - std::min(text.size(), all - std::min(all, read));
  if (event.kind == Event::Kind::serial) {
    const std::size_t at = text.find(event.text, from);
    if (at != std::string::npos) read = all - (text.size() - at - event.text.size());
  } else if (event.kind == Event::Kind::line) {
    read = all;
  }
}

Simulation::Simulation(Trial trial) : trial_(std::move(trial)) {
  trial_.target = target_of(trial_);
  report_to_github();
  in_ = std::make_unique<Inside>(trial_);
}

Drive Simulation::run_for(Duration time, const char* file, int line) {
  const std::int64_t begin = in_->now_ns();
  const bool was_over = over();
  if (!was_over) in_->go_on(begin + in_ticks(time), {});
  if (over() && !was_over) {
    in_->ended_file = file;
    in_->ended_line = line;
  }
  return in_->drive(begin);
}

Drive Simulation::run_until(const Event& event, Within<Duration> within, const char* file, int line) {
  const std::int64_t begin = in_->now_ns();
  std::vector<wire::Stop> stops;
  std::vector<const Event::One*> stopping;
  const Event::One* ending = nullptr;
  for (const Event::One& one : event.any()) {
    if (one.kind == Event::Kind::end) {
      in_->log->verdict_asked = true;
      ending = &one;
      continue;
    }
    stops.push_back(in_->stop_for(one));
    stopping.push_back(&one);
  }
  const bool was_over = over();
  if (!was_over) in_->go_on(begin + in_ticks(within.most), stops);
  if (over() && !was_over) {
    in_->ended_file = file;
    in_->ended_line = line;
  }
  Drive drive = in_->drive(begin);
  if (over()) {
    const bool awaited = ending && in_->log->result->verdict == ending->text;
    if (!awaited)
      drive.fail_with(
          fmt::format("the run was over at {} before {}", seconds(in_->now_ns()), event.clause()));
  } else if (in_->run->state().stop < 0) {
    const Moment here = moment();
    drive.fail_with(fmt::format("it did not happen within {} that {}; the robot is now at {}{}",
                                seconds(within.most), event.clause(), place_of(here.pose),
                                here.left == 0.0 && here.right == 0.0 ? ", its motors off" : ""));
  } else {
    in_->read_on(*stopping[static_cast<std::size_t>(in_->run->state().stop)]);
  }
  return drive;
}

Drive Simulation::run_to_the_end(const char* file, int line) {
  const std::int64_t begin = in_->now_ns();
  in_->ended_file = file;
  in_->ended_line = line;
  if (!over()) in_->go_on(-1, {});
  return in_->drive(begin);
}

Duration Simulation::now() const { return Duration(in_->now_ns()); }

void Simulation::act(const std::string& line) {
  in_->run->act(line);
  in_->read = in_->run->state().serial_bytes;
  in_->log->replay = robosim::testing::replay_command(in_->stage, in_->log->artifacts, true);
}

void Simulation::press(const std::string& button, Duration time) { act("press " + button + " " + ms(time)); }
void Simulation::hold(const std::string& button) { act("press " + button); }
void Simulation::release(const std::string& button) { act("release " + button); }
void Simulation::send(const std::string& text) { act("send " + in_quotes(text)); }
void Simulation::cover(const std::string& sensor, Duration time) { act("cover " + sensor + " " + ms(time)); }
void Simulation::place(int column, int row, char facing) {
  act(fmt::format("place {},{} {}", column, row, facing));
}
void Simulation::turn_round() {
  static constexpr char kDirections[] = {'E', 'N', 'W', 'S'};
  const Moment here = moment();
  const auto quarter = static_cast<int>(std::lround(here.pose.yaw_rad * 2.0 / M_PI));
  place(here.pose.column, here.pose.row, kDirections[(quarter + 2 + 4) % 4]);
}
void Simulation::power_off(Duration time) { act("power off " + ms(time)); }

Moment Simulation::moment() const { return moment_of(*in_->log, in_->log->samples.back()); }

double Simulation::reading(const std::string& part) const {
  const std::vector<std::string>& names = in_->log->started.readings;
  const auto found = std::find(names.begin(), names.end(), part);
  if (found == names.end())
    throw InputError(
        fmt::format("the robot has no part {} that could be read; those are {}", part, one_of(names)));
  return moment().readings[static_cast<std::size_t>(found - names.begin())];
}

bool Simulation::is_on(const std::string& part) const { return reading(part) >= 0.5; }

std::vector<std::string> Simulation::stations_visited() const {
  return in_->log->legs.empty() ? std::vector<std::string>() : in_->log->legs.back().at_end.stations;
}

std::string Simulation::serial() const { return in_->log->serial; }
std::vector<std::uint8_t> Simulation::eeprom() const { return in_->run->eeprom(); }
Graph Simulation::true_graph() const { return graph_of_floor(in_->stage.request); }
bool Simulation::over() const { return in_->run->over(); }

std::string Simulation::verdict() const {
  in_->log->verdict_asked = true;
  return over() ? in_->run->result().verdict : "";
}

Drive Simulation::so_far() const { return in_->drive(0); }

std::string Simulation::replay_command() const {
  return fmt::format("{} --for {}ms", in_->log->replay, in_->now_ns() / kMillisecond_ns);
}

std::uint64_t Simulation::eeprom_writes() { return in_->run->end().eeprom_writes; }

std::string Simulation::trace_hash() { return in_->run->end().trace_hash; }

void PrintTo(const Simulation& simulation, std::ostream* out) { PrintTo(simulation.so_far(), out); }

Simulation::~Simulation() {
  try {
    const wire::RunResult& result = in_->run->end();
    RunLog& log = *in_->log;
    const bool failed = ::testing::Test::HasFailure();
    if (!failed && is_failure(result.verdict) && !log.verdict_asked) {
      ADD_FAILURE_AT(in_->ended_file ? in_->ended_file : __FILE__, in_->ended_line)
          << "the run failed by itself, which no expectation looked at\n  " << so_far().title()
          << so_far().epilogue(now());
    }
    if (in_->stage.counted)
      keep_coverage(coverage_folder(trial_.target), in_->stage.request.counters, in_->stage.counted->request,
                    in_->stage.counted->image, replay_command() + "\n" + in_->run->script());
    record_trace(result.trace_hash);
    if (!is_rehearsal()) record_figures(log, result);
    if (::testing::Test::HasFailure() && !log.artifacts.empty()) {
      const std::string problem = keep(log, in_->stage, in_->run->script(), *in_->runner);
      if (!problem.empty()) std::fputs(fmt::format("robosim: {}\n", problem).c_str(), stderr);
    }
  } catch (const std::exception& problem) {
    in_->runner.condemn();
    ADD_FAILURE() << problem.what();
  }
  std::error_code ignored;
  if (!in_->stage.scratch.empty()) std::filesystem::remove_all(in_->stage.scratch, ignored);
}

}  // namespace robosim::testing
