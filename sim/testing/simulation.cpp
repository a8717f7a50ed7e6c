#include "robosim/testing/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string_view>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/testing/artifacts.h"
#include "sim/testing/coverage.h"
#include "sim/testing/reports.h"
#include "sim/testing/silent_run.h"
#include "sim/testing/simulation_impl.h"

namespace robosim::testing {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// Rounds up to whole ticks.
std::int64_t in_ticks(Duration time) {
  return (time.count() + kMillisecond_ns - 1) / kMillisecond_ns * kMillisecond_ns;
}

std::string ms(Duration time) { return std::to_string(in_ticks(time) / kMillisecond_ns) + "ms"; }

}  // namespace

Simulation::Simulation(Trial trial) : trial_(std::move(trial)) {
  trial_.target = target_of(trial_);
  report_to_github();
  auto run = std::make_shared<SharedRun>(trial_.target);
  impl_ = std::make_unique<Impl>(trial_, run, resolve_trial(trial_, *run->runner));
  RunLog& log = *impl_->log;
  log.artifacts = artifact_folder();
  log.replay = robosim::testing::replay_command(impl_->resolved_trial, log.artifacts, !trial_.script.empty());
  run->begin(impl_->resolved_trial.request);
}

Simulation::Simulation(Trial trial, std::unique_ptr<Impl> inside)
    : trial_(std::move(trial)), impl_(std::move(inside)) {}

Drive Simulation::run_for(Duration time, const char* file, int line) {
  SharedRun& run = *impl_->shared;
  const std::int64_t begin = run.now_ns, end = begin + in_ticks(time);
  while (!run.over() && run.now_ns < end) run.go_on(end, {}, {file, line});
  return impl_->drive(begin);
}

Drive Simulation::run_until(const Event& event, Within<Duration> within, const char* file, int line) {
  SharedRun& run = *impl_->shared;
  const std::int64_t begin = run.now_ns, end = begin + in_ticks(within.most);
  std::vector<result::Stop> stops;
  std::vector<const Event::One*> stopping;
  const Event::One* ending = nullptr;
  for (const Event::One& one : event.any()) {
    if (one.kind == Event::Kind::end) {
      impl_->log->verdict_asked = true;
      ending = &one;
      continue;
    }
    stops.push_back(impl_->stop_for(one));
    stopping.push_back(&one);
  }
  int stop = -1;
  while (!over() && stop < 0 && run.now_ns < end) {
    run.go_on(end, stops, {file, line});
    stop = over() ? -1 : impl_->state().stop;
  }
  Drive drive = impl_->drive(begin);
  if (over()) {
    const bool awaited = ending && impl_->verdict() == ending->text;
    if (!awaited)
      drive.fail_with(fmt::format("the run ended at {}, before {}", seconds(now()), event.clause()));
  } else if (stop < 0) {
    drive.fail_with(fmt::format("it did not happen within {} that {}", seconds(within.most), event.clause()));
  } else {
    impl_->read_on(*stopping[static_cast<std::size_t>(stop)]);
  }
  return drive;
}

Drive Simulation::run_to_the_end(const char* file, int line) {
  SharedRun& run = *impl_->shared;
  const std::int64_t begin = run.now_ns;
  while (!over()) run.go_on(std::numeric_limits<std::int64_t>::max(), {}, {file, line});
  return impl_->drive(begin);
}

Duration Simulation::now() const { return Duration(impl_->shared->now_ns); }

void Simulation::act(const std::string& line, const char* file, int at) {
  try {
    impl_->shared->run->act(line, impl_->number);
  } catch (const InputError& error) {
    // Removes the place "script:1: ", because the script has only this line.
    constexpr std::string_view kOnlyLine = "1: ";
    std::string message = error.message();
    const std::size_t place = message.find(kOnlyLine);
    if (place < message.find(' ')) message.erase(0, place + kOnlyLine.size());
    throw InputError({file, at}, message);
  }
  impl_->read = impl_->state().serial_bytes;
  if (!impl_->shared->of_fleet)
    impl_->log->replay = robosim::testing::replay_command(impl_->resolved_trial, impl_->log->artifacts, true);
}

void Simulation::press(const std::string& button, Duration time, const char* file, int at) {
  act(fmt::format("press {} {}", button, ms(time)), file, at);
}
void Simulation::hold(const std::string& button, const char* file, int at) {
  act(fmt::format("press {}", button), file, at);
}
void Simulation::release(const std::string& button, const char* file, int at) {
  act(fmt::format("release {}", button), file, at);
}
void Simulation::send(const std::string& text, const char* file, int at) {
  act(fmt::format("send {}", in_quotes(text)), file, at);
}
void Simulation::cover(const std::string& sensor, Duration time, const char* file, int at) {
  act(fmt::format("cover {} {}", sensor, ms(time)), file, at);
}
void Simulation::place(int column, int row, char facing, const char* file, int at) {
  act(fmt::format("place {},{} {}", column, row, facing), file, at);
}
void Simulation::turn_round(const char* file, int at) {
  static constexpr char kDirections[] = {'E', 'N', 'W', 'S'};
  const Moment here = moment();
  const auto quarter = static_cast<int>(std::lround(here.pose.yaw_rad * 2.0 / M_PI));
  place(here.pose.column, here.pose.row, kDirections[(quarter + 2 + 4) % 4], file, at);
}
void Simulation::power_off(Duration time, const char* file, int at) {
  act(fmt::format("power off {}", ms(time)), file, at);
}

Moment Simulation::moment() const { return moment_of(*impl_->log, impl_->log->samples.back()); }

double Simulation::reading(const std::string& part, const char* file, int at) const {
  const std::vector<std::string>& names = impl_->log->started.readings;
  const auto found = std::find(names.begin(), names.end(), part);
  if (found == names.end())
    throw InputError({file, at}, fmt::format("unknown part to read: {}", expected_one_of(part, names)));
  return moment().readings[static_cast<std::size_t>(found - names.begin())];
}

bool Simulation::is_on(const std::string& part, const char* file, int at) const {
  return reading(part, file, at) >= 0.5;
}

std::vector<std::string> Simulation::stations_visited() const {
  return impl_->log->legs.empty() ? std::vector<std::string>() : impl_->log->legs.back().at_end.stations;
}

std::string Simulation::serial() const { return impl_->log->serial; }
std::vector<std::uint8_t> Simulation::eeprom() const { return impl_->shared->run->eeprom(impl_->number); }
Graph Simulation::true_graph() const { return graph_of_floor(impl_->resolved_trial.request); }
bool Simulation::over() const { return impl_->over(); }

std::string Simulation::verdict() const {
  impl_->log->verdict_asked = true;
  return impl_->verdict();
}

Drive Simulation::so_far() const { return impl_->drive(0); }

std::string Simulation::replay_command() const {
  return fmt::format("{} --for {}ms", impl_->log->replay, impl_->shared->now_ns / kMillisecond_ns);
}

std::uint64_t Simulation::eeprom_writes() {
  impl_->shared->run->end();
  return impl_->shared->result(impl_->number).eeprom_writes;
}

std::string Simulation::trace_hash() {
  impl_->shared->run->end();
  return impl_->shared->result(impl_->number).trace_hash;
}

void PrintTo(const Simulation& simulation, std::ostream* out) { PrintTo(simulation.so_far(), out); }

Simulation::~Simulation() {
  SharedRun& run = *impl_->shared;
  if (run.of_fleet) return;
  try {
    const result::RunResult& result = run.run->end();
    RunLog& log = *impl_->log;
    impl_->complain_unasked(result);
    impl_->complain_detected(result);
    if (impl_->resolved_trial.counted)
      keep_coverage(coverage_folder(trial_.target), impl_->resolved_trial.request.counters,
                    impl_->resolved_trial.counted->request, impl_->resolved_trial.counted->image,
                    replay_command() + "\n" + run.run->script());
    record_trace(result.trace_hash);
    if (!is_silent_run()) record_figures(log, result);
    if (::testing::Test::HasFailure() && !log.artifacts.empty()) {
      const std::string problem = keep(log, impl_->resolved_trial, run.run->script(), *run.runner);
      if (!problem.empty()) std::fputs(fmt::format("robosim: {}\n", problem).c_str(), stderr);
      record_kept(log.artifacts);
    }
  } catch (const std::exception& problem) {
    run.runner.condemn();
    ADD_FAILURE() << problem.what();
  }
  std::error_code ignored;
  if (!impl_->resolved_trial.scratch.empty())
    std::filesystem::remove_all(impl_->resolved_trial.scratch, ignored);
}

}  // namespace robosim::testing
