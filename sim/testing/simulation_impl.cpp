#include "sim/testing/simulation_impl.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/base/error.h"
#include "sim/map/map.h"
#include "sim/testing/artifacts.h"
#include "sim/wire/agent_of.h"

namespace robosim::testing {
namespace {

bool is_failure(const std::string& verdict) {
  return verdict == "lost" || verdict == "stuck" || verdict == "toppled" || verdict == "hung" ||
         verdict == "crashed" || verdict == "over_budget";
}

}  // namespace

void SharedRun::begin(const wire::RunRequest& request) {
  run = std::make_unique<client::DrivenRun>(*runner, request, [this](const wire::Event& event) {
    if (const auto agent = static_cast<std::size_t>(wire::agent_of(event)); agent < robots.size())
      robots[agent]->take(event);
  });
  for (Simulation::Impl* robot : robots) robot->begin();
}

void SharedRun::go_on(std::int64_t to_ns, const std::vector<result::Stop>& stops, Spot spot) {
  const std::int64_t begin_ns = now_ns;
  try {
    run->go_on(to_ns, stops);
  } catch (const wire::RunnerError&) {
    runner.condemn();
    throw;
  }
  if (!over()) now_ns = run->state().t_ns;
  for (std::size_t i = 0; over() && i < robots.size(); ++i)
    now_ns = std::max<std::int64_t>(now_ns, std::llround(result(i).time_s * 1e3) * 1'000'000);
  for (Simulation::Impl* robot : robots) robot->note_leg(begin_ns, spot);
}

const result::RunResult& SharedRun::result(std::size_t number) const {
  return number == 0 ? run->result() : run->result().others.at(number - 1);
}

Simulation::Impl::Impl(const Trial& trial, std::shared_ptr<SharedRun> run, ResolvedTrial from)
    : resolved_trial(std::move(from)), shared(std::move(run)), number(shared->robots.size()) {
  shared->robots.push_back(this);
  log->trial = trial;
  log->sketch_name = resolved_trial.sketch_title;
  log->map_name = resolved_trial.map_is_text ? "the test's map"
                                             : std::filesystem::path(resolved_trial.map).stem().string();
  log->robot_name = resolved_trial.robot_is_text ? "the test's robot" : resolved_trial.robot.name;
}

void Simulation::Impl::begin() {
  log->samples.push_back(state().sample);
  log->resources = state().resources;
  log->has_light_line = map::read_map(shared->robots.front()->resolved_trial.request.map).light_line;
  for (const std::string& reading : log->started.readings) {
    const auto& sensors = resolved_trial.robot.sensors;
    log->is_line_sensor.push_back(std::any_of(sensors.begin(), sensors.end(),
                                              [&](const auto& sensor) { return sensor.name == reading; }));
  }
}

const wire::Paused& Simulation::Impl::state() const {
  const wire::Paused& first = shared->run->state();
  return number == 0 ? first : first.others.at(number - 1);
}

std::string Simulation::Impl::verdict() const {
  if (log->result) return log->result->verdict;
  return shared->over() ? shared->result(number).verdict : "";
}

void Simulation::Impl::take(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event)) log->started = *started;
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    if (log->samples.empty() || log->samples.back().t_us < sample->t_us) log->samples.push_back(*sample);
  }
  if (const auto* note = std::get_if<wire::Note>(&event))
    log->add({note->t_ns, on_one_line(note->text), note->is<result::CollisionBegan>() != nullptr});
  if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    log->serial += serial->text;
    log->said.push_back({serial->t_ns, log->serial.size()});
    log->add({serial->t_ns, "the sketch says " + in_quotes(serial->text)});
  }
}

void Simulation::Impl::note_leg(std::int64_t begin_ns, Spot spot) {
  last = spot;
  const bool had_verdict = log->result && !log->result->verdict.empty();
  if (had_verdict && !shared->over()) return;
  RunLog::Leg leg;
  leg.begin_ns = begin_ns;
  if (shared->over()) {
    log->result = shared->result(number);  // the full result replaces the early verdict
    if (had_verdict) return;
    ended = spot;
    leg.end_ns = std::max<std::int64_t>(leg.begin_ns, std::llround(log->result->time_s * 1e3) * 1'000'000);
    leg.at_end = log->result->metrics;
    log->resources = log->result->resources;
    for (const wire::Sample& sample : log->samples) {
      if (sample.t_us * 1000 < leg.begin_ns || sample.cross_track_mm < leg.worst_mm) continue;
      leg.worst_mm = sample.cross_track_mm;
      leg.worst_ns = sample.t_us * 1000;
      leg.worst_x_mm = sample.x_mm;
      leg.worst_y_mm = sample.y_mm;
    }
  } else {
    const wire::Paused& here = state();
    leg.end_ns = here.t_ns;
    leg.worst_mm = here.worst.cross_track_mm;
    leg.worst_ns = here.worst.t_ns;
    leg.worst_x_mm = here.worst.x_mm;
    leg.worst_y_mm = here.worst.y_mm;
    leg.at_end = here.metrics;
    log->resources = here.resources;
    if (log->samples.back().t_us < here.sample.t_us) log->samples.push_back(here.sample);
    if (!here.verdict.empty()) {
      log->result.emplace();
      log->result->verdict = here.verdict;
      log->result->why = here.why;
      log->result->metrics = here.metrics;
      ended = spot;
    }
  }
  log->legs.push_back(std::move(leg));
}

result::Stop Simulation::Impl::stop_for(const Event::One& event) const {
  result::Stop stop = [&] {
    switch (event.kind) {
      case Event::Kind::serial:
        return result::Stop::serial(event.text, read);
      case Event::Kind::line:
        return result::Stop::line(event.text, read);
      case Event::Kind::note:
        return result::Stop::note(event.text);
      case Event::Kind::event:
        return result::Stop::event(event.text);
      case Event::Kind::visited:
        return result::Stop::visited(event.text);
      case Event::Kind::at:
        return result::Stop::at(event.text);
      case Event::Kind::reading:
        return result::Stop::reading(event.text, event.level);
      case Event::Kind::pin:
        return result::Stop::pin(event.text, event.level);
      case Event::Kind::motors:
        return result::Stop::motors(event.level);
      case Event::Kind::rest:
      case Event::Kind::end:
        return result::Stop::rest(event.time.count());
    }
    return result::Stop{};
  }();
  stop.agent = static_cast<int>(number);
  return stop;
}

// Moves the search position past the text that was just found.
void Simulation::Impl::read_on(const Event::One& event) {
  const std::string& text = log->serial;
  const std::size_t all = state().serial_bytes;
  const std::size_t from = text.size() - std::min(text.size(), all - std::min(all, read));
  if (event.kind == Event::Kind::serial) {
    const std::size_t at = text.find(event.text, from);
    if (at != std::string::npos) read = all - (text.size() - at - event.text.size());
  } else if (event.kind == Event::Kind::line) {
    read = all;
  }
}

void Simulation::Impl::complain_unasked(const result::RunResult& result) const {
  if (::testing::Test::HasFailure() || !is_failure(result.verdict) || log->verdict_asked) return;
  const Drive all = drive(0);
  ADD_FAILURE_AT(ended.file ? ended.file : __FILE__, ended.line)
      << "the run failed, and no expectation checked its verdict\n  " << all.title()
      << all.epilogue(all.end());
}

void Simulation::Impl::complain_detected(const result::RunResult& result) const {
  if (result.detected.empty()) return;
  std::string seen;
  for (const result::Detected& one : result.detected)
    seen += fmt::format("\n  detected: {} [{}]", result::text_of(one), one.detector);
  const Drive all = drive(0);
  ADD_FAILURE_AT(last.file ? last.file : __FILE__, last.line)
      << "the sketch works here, but would fail on a real robot (.detect = false turns this check off)"
      << seen << "\n  " << all.title() << "\n  replay: " << log->replay
      << fmt::format(" --for {}ms --sanitize", shared->now_ns / 1'000'000);
}

}  // namespace robosim::testing
