#include "robosim/testing/drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "sim/testing/history.h"

namespace robosim::testing {
namespace {

constexpr std::size_t kEventsTold = 6;

/// The end of the last leg that ended by then, or null.
const History::Leg* leg_until(const History& history, std::int64_t t_ns) {
  const History::Leg* found = nullptr;
  for (const History::Leg& leg : history.legs)
    if (leg.end_ns <= t_ns) found = &leg;
  return found;
}

}  // namespace

Drive::Drive(std::shared_ptr<const History> history, Duration begin, Duration end)
    : history_(std::move(history)), begin_(begin), end_(end) {}

std::string Drive::serial() const {
  const auto bytes_until = [&](Duration t) {
    std::size_t bytes = 0;
    for (const History::Said& said : history_->said)
      if (said.t_ns <= t.count()) bytes = said.end;
    return bytes;
  };
  const std::size_t from = begin_.count() == 0 ? 0 : bytes_until(begin_);
  return history_->serial.substr(from, bytes_until(end_) - from);
}

std::vector<Moment> Drive::moments() const {
  std::vector<Moment> moments;
  for (const wire::Sample& sample : history_->samples) {
    const Duration t = std::chrono::microseconds(sample.t_us);
    if (t >= begin_ && t <= end_) moments.push_back(moment_of(*history_, sample));
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
  const History::Leg* worst = nullptr;
  for (const History::Leg& leg : history_->legs) {
    if (leg.begin_ns < begin_.count() || leg.end_ns > end_.count()) continue;
    if (!worst || leg.worst_mm > worst->worst_mm) worst = &leg;
  }
  if (!worst) return moments().empty() ? Moment{} : moments().front();
  // The sample before it knows the rest.
  wire::Sample sample;
  for (const wire::Sample& s : history_->samples)
    if (s.t_us * 1000 <= worst->worst_ns) sample = s;
  sample.t_us = worst->worst_ns / 1000;
  sample.x_mm = worst->worst_x_mm;
  sample.y_mm = worst->worst_y_mm;
  sample.cross_track_mm = worst->worst_mm;
  return moment_of(*history_, sample);
}

Length Drive::distance() const {
  const History::Leg* before = leg_until(*history_, begin_.count());
  const History::Leg* after = leg_until(*history_, end_.count());
  const double from_m = before ? before->at_end.distance_m : 0.0;
  return {after ? 1e3 * (after->at_end.distance_m - from_m) : 0.0};
}

int Drive::collisions() const {
  const History::Leg* before = leg_until(*history_, begin_.count());
  const History::Leg* after = leg_until(*history_, end_.count());
  return (after ? after->at_end.collisions : 0) - (before ? before->at_end.collisions : 0);
}

std::string Drive::verdict() const {
  history_->verdict_asked = true;
  const bool here = history_->result && history_->legs.back().end_ns <= end_.count();
  return here ? history_->result->verdict : "";
}

std::string Drive::why() const { return verdict().empty() ? "" : history_->result->why; }

std::optional<Usage> Drive::usage() const {
  if (!history_->resources) return std::nullopt;
  const wire::Resources& used = *history_->resources;
  return Usage{used.flash_bytes, used.ram_bytes, used.stack_bytes_max,
               Duration(static_cast<std::int64_t>(used.loop_us_max * 1e3))};
}

std::string Drive::title() const {
  const Trial& trial = history_->trial;
  return fmt::format("{} on {} ({}, target {}, seed {}), {} to {}", history_->sketch_name, history_->map_name,
                     history_->robot_name, trial.target, trial.seed, seconds(begin_), seconds(end_));
}

std::string Drive::epilogue(Duration until) const {
  std::string text;
  std::vector<const History::Entry*> told;
  for (const History::Entry& entry : history_->events)
    if (entry.t_ns <= until.count()) told.push_back(&entry);
  if (told.size() > kEventsTold) told.erase(told.begin(), told.end() - kEventsTold);
  text += told.empty() ? "\n  before that: nothing was said or done" : "\n  before that:";
  for (const History::Entry* entry : told)
    text += fmt::format("\n    {:>10}  {}", seconds(entry->t_ns), entry->text);
  if (history_->result && history_->result->verdict != "interrupted")
    text += fmt::format("\n  the run ended at {} as {}: {}", seconds(history_->legs.back().end_ns),
                        history_->result->verdict, history_->result->why);
  text += fmt::format("\n  replay: {} --for {}ms", history_->replay, end_.count() / 1'000'000);
  if (!history_->artifacts.empty()) text += fmt::format("\n  kept:   {}", history_->artifacts);
  return text;
}

Drive::operator ::testing::AssertionResult() const {
  if (arrived()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << title() << ": " << complaint_ << epilogue(end_);
}

void PrintTo(const Drive& drive, std::ostream* out) { *out << drive.title(); }

}  // namespace robosim::testing
