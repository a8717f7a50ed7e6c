#include "robosim/testing/drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "sim/testing/artifacts.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {
namespace {

constexpr std::size_t kEventsTold = 6;

/// Returns the last leg that ended at or before `t_ns`, or null.
const RunLog::Leg* leg_until(const RunLog& log, std::int64_t t_ns) {
  const RunLog::Leg* found = nullptr;
  for (const RunLog::Leg& leg : log.legs)
    if (leg.end_ns <= t_ns) found = &leg;
  return found;
}

}  // namespace

Drive::Drive(std::shared_ptr<const RunLog> log, Duration begin, Duration end)
    : log_(std::move(log)), begin_(begin), end_(end) {}

std::string Drive::serial() const {
  const auto bytes_until = [&](Duration t) {
    std::size_t bytes = 0;
    for (const RunLog::Said& said : log_->said)
      if (said.t_ns <= t.count()) bytes = said.end;
    return bytes;
  };
  const std::size_t from = begin_.count() == 0 ? 0 : bytes_until(begin_);
  return log_->serial.substr(from, bytes_until(end_) - from);
}

std::vector<Moment> Drive::moments() const {
  std::vector<Moment> moments;
  for (const wire::Sample& sample : log_->samples) {
    const Duration t = std::chrono::microseconds(sample.t_us);
    if (t >= begin_ && t <= end_) moments.push_back(moment_of(*log_, sample));
  }
  return moments;
}

std::vector<std::string> Drive::stations() const {
  std::vector<std::string> stations;
  std::string at;
  bool first = true;
  for (const Moment& moment : moments()) {
    if (!first && moment.station != at && !moment.station.empty()) stations.push_back(moment.station);
    at = moment.station;
    first = false;
  }
  return stations;
}

Moment Drive::worst() const {
  const RunLog::Leg* worst = nullptr;
  for (const RunLog::Leg& leg : log_->legs) {
    if (leg.begin_ns < begin_.count() || leg.end_ns > end_.count()) continue;
    if (!worst || leg.worst_mm > worst->worst_mm) worst = &leg;
  }
  if (!worst) return moments().empty() ? Moment{} : moments().front();
  // The leg stores only the time, place and error of its worst moment. The other values come from the last
  // sample before that moment.
  wire::Sample sample;
  for (const wire::Sample& s : log_->samples)
    if (s.t_us * 1000 <= worst->worst_ns) sample = s;
  sample.t_us = worst->worst_ns / 1000;
  sample.x_mm = worst->worst_x_mm;
  sample.y_mm = worst->worst_y_mm;
  sample.cross_track_mm = worst->worst_mm;
  return moment_of(*log_, sample);
}

Length Drive::distance() const {
  const RunLog::Leg* before = leg_until(*log_, begin_.count());
  const RunLog::Leg* after = leg_until(*log_, end_.count());
  const double from_m = before ? before->at_end.distance_m : 0.0;
  return {after ? 1e3 * (after->at_end.distance_m - from_m) : 0.0};
}

int Drive::collisions() const {
  const RunLog::Leg* before = leg_until(*log_, begin_.count());
  const RunLog::Leg* after = leg_until(*log_, end_.count());
  return (after ? after->at_end.collisions : 0) - (before ? before->at_end.collisions : 0);
}

std::string Drive::verdict() const {
  log_->verdict_asked = true;
  const bool here = log_->result && log_->legs.back().end_ns <= end_.count();
  return here ? log_->result->verdict : "";
}

std::optional<Score> Drive::score() const {
  if (verdict().empty() || std::isnan(log_->result->metrics.score)) return std::nullopt;
  const result::Metrics& metrics = log_->result->metrics;
  Score score{metrics.score, metrics.score_unit, {}};
  for (const result::ScorePart& part : metrics.score_parts)
    score.parts.push_back({part.part, part.count, part.value});
  return score;
}

std::string Drive::why() const { return verdict().empty() ? "" : log_->result->why; }

std::optional<Usage> Drive::usage() const {
  if (!log_->resources) return std::nullopt;
  const result::Resources& used = *log_->resources;
  return Usage{used.flash_bytes, used.ram_bytes, used.stack_bytes_max,
               Duration(static_cast<std::int64_t>(used.loop_us_max * 1e3)), used.free_bytes_min};
}

std::string Drive::title() const {
  const Trial& trial = log_->trial;
  return fmt::format("{}{} on {} ({}, target {}, seed {}), {} to {}",
                     log_->name.empty() ? "" : log_->name + ": ", log_->sketch_name, log_->map_name,
                     log_->robot_name, trial.target, trial.seed, seconds(begin_), seconds(end_));
}

std::string Drive::epilogue(Duration until) const {
  std::string text;
  std::vector<const RunLog::Entry*> told;
  for (const RunLog::Entry& entry : log_->events)
    if (entry.t_ns <= until.count()) told.push_back(&entry);
  if (told.size() > kEventsTold) told.erase(told.begin(), told.end() - kEventsTold);
  text += told.empty() ? "\n  before that: no events" : "\n  before that:";
  for (const RunLog::Entry* entry : told)
    text += fmt::format("\n    {:>10}  {}", seconds(entry->t_ns), entry->text);
  if (const auto all = moments(); !all.empty()) {
    const Moment& last = all.back();
    text += fmt::format("\n  at {} it is at {}, ", seconds(end_), place_of(last.pose));
    text += last.left == 0.0 && last.right == 0.0
                ? "its motors off"
                : fmt::format("driving at {} mm/s", std::lround(last.speed.mm_per_s));
  }
  if (log_->result && log_->result->verdict != "interrupted")
    text += fmt::format("\n  the run ended at {} as {}: {}", seconds(log_->legs.back().end_ns),
                        log_->result->verdict, log_->result->why);
  text += fmt::format("\n  replay: {} --for {}ms", log_->replay, end_.count() / 1'000'000);
  if (!log_->artifacts.empty())
    text += fmt::format("\n  kept:   {}; open its {} in a browser", log_->artifacts, kPage);
  return text;
}

Drive::operator ::testing::AssertionResult() const {
  if (arrived()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << title() << ": " << complaint_ << epilogue(end_);
}

void PrintTo(const Drive& drive, std::ostream* out) { *out << drive.title(); }

}  // namespace robosim::testing
