#include "sim/campaign/rerun/sanitizer_rerun.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/build/static_checks.h"
#include "sim/campaign/rerun/clock_wrap_detector.h"
#include "sim/launch/client/interrupts.h"
#include "sim/result/advice.h"

namespace robosim::campaign {
namespace {

constexpr double kLongest_of_timeout_s = 60.0;
// A sketch with checks takes longer to crash.
constexpr double kMargin_of_crash_s = 1.0;

// Returns the time limit of the second run. A check that fails later does not explain the first result.
double limit_s(const result::RunResult& first) {
  if (first.verdict == "timeout") return std::min(kLongest_of_timeout_s, first.time_s);
  return first.verdict == "crashed" ? first.time_s + kMargin_of_crash_s : first.time_s;
}

std::string place_of(const result::Crash& fault) {
  if (fault.where.file.empty()) return "";
  const std::string place = fmt::format("{}:{}", fault.where.file, fault.where.line);
  return fault.where.function.empty() ? " at " + place
                                      : fmt::format(" in {}, {}", fault.where.function, place);
}

void listen_to_nothing(wire::RunRequest& request) {
  request.counters.clear();
  request.samples_every_ns = request.columns_every_ns = 0;
  request.gdb_port = 0;
  request.pins = request.serial = request.notes = request.io = false;
}

bool has_failed(const result::RunResult& first) {
  return first.verdict == "lost" || first.verdict == "stuck" || first.verdict == "hung" ||
         first.verdict == "timeout";
}

// Returns the messages about variables that may be used before they have a value, without "warning: ".
std::vector<std::string> about_unset_variables(const std::string& messages) {
  constexpr std::string_view kMark = "warning: ";
  std::vector<std::string> found;
  for (std::size_t at = 0; at < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', at), messages.size());
    std::string line = messages.substr(at, end - at);
    at = end + 1;
    const std::size_t mark = line.find(kMark);
    if (mark == line.npos || line.find(build::kUnset) == line.npos) continue;
    found.push_back(line.erase(mark, kMark.size()));
  }
  return found;
}

}  // namespace

bool deserves_sanitizer_rerun(const build::Request& sketch, const result::RunResult& first) {
  if (sketch.sanitize || (first.crash && !first.crash->check.empty())) return false;
  if (sketch.target == "host") return first.verdict == "crashed";
  return sketch.target == "avr" && first.verdict != "reached" && first.verdict != "interrupted" &&
         first.verdict != "over_budget";
}

Checked rerun_with_sanitizers(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                              const result::RunResult& first, std::size_t robot) {
  build::Request checked = sketch;
  checked.sanitize = true;
  checked.coverage = false;
  request.for_ns = std::min(request.for_ns, static_cast<std::int64_t>(limit_s(first) * 1e9));
  listen_to_nothing(request);
  try {
    const build::Image built = build::build(checked);
    const std::vector<std::string> unset = about_unset_variables(built.messages);
    (robot == 0 ? request.image : request.agents[robot - 1].image) = built.image.string();
    const client::Interrupts interrupts(runner);
    const result::RunResult all = runner.run(request);
    const result::RunResult& second = robot == 0 ? all : all.others.at(robot - 1);
    if (second.verdict == "interrupted") return {};
    if (!second.crash) return {std::nullopt, true, unset};
    if (second.crash->check.empty()) return {std::nullopt, false, unset};
    return {result::Finding{*second.crash, second.time_s, second.next}, false, unset};
  } catch (const InputError&) {
    return {};
  }
}

bool deserves_detectors(const build::Request& sketch, const result::RunResult& first) {
  // In a build with checks, a torn number ends the run, before detectors can find anything else.
  const bool is_torn =
      first.crash && (first.crash->check.starts_with("torn_") || first.crash->check == "lost_update");
  if ((first.verdict == "crashed" && !is_torn) || first.verdict == "interrupted") return false;
  return sketch.sanitize || has_failed(first);
}

std::vector<std::string> unset_variables(const build::Request& sketch, const result::RunResult& first) {
  if (sketch.sanitize || !has_failed(first)) return {};
  build::Request checked = sketch;
  checked.sanitize = true;
  checked.coverage = false;
  try {
    return about_unset_variables(build::build(checked).messages);
  } catch (const InputError&) {
    return {};
  }
}

std::string after_unset(const std::vector<std::string>& unset, const std::string& next) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(unset.size(), kMost); ++i)
    text += (text.empty() ? "" : "; ") + unset[i];
  return text.empty() || next.empty() ? text + next : text + "; " + next;
}

AsFlashed rerun_with_detectors(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                               const result::RunResult& first) {
  build::Request plain = sketch;
  plain.sanitize = plain.coverage = false;
  if (first.verdict == "timeout")
    request.for_ns = std::min(request.for_ns, static_cast<std::int64_t>(kLongest_of_timeout_s * 1e9));
  listen_to_nothing(request);
  request.detect = true;
  request.image = build::build(plain).image.string();
  const client::Interrupts interrupts(runner);
  const result::RunResult second = runner.run(request);
  AsFlashed found{second.detected, std::nullopt};
  if (!sketch.sanitize || second.verdict == "interrupted") return found;
  if (second.verdict == "crashed") {
    found.crashed = second;
    found.crashed->why = fmt::format("With checks the verdict is “{}”; without them, as flashed: {}",
                                     first.verdict, second.why);
    return found;
  }
  if (sketch.target != "avr") return found;
  for (result::Detected& seen : detect_clock_wrap(runner, request, second))
    found.detected.push_back(std::move(seen));
  return found;
}

std::string next_of(const result::RunResult& result) {
  const char* const flags = result.next_by == "host"       ? " (--target host)"
                            : result.next_by == "watching" ? " (--view --speed 0.2, or --record run.csv)"
                            : result.next_by == "script"   ? " (--script FILE)"
                                                           : "";
  return result.next + flags;
}

namespace {

std::string next_without_unset(const result::RunResult& first, const Checked& second) {
  if (const auto& finding = second.finding)
    return fmt::format(
        "{}{}, {:.2f} s after the start: this is the first failed check of a second run with checks "
        "(--sanitize).{}{}",
        finding->fault.reason, place_of(finding->fault), finding->time_s, finding->advice.empty() ? "" : " ",
        finding->advice);
  if (!second.is_clean || (first.verdict != "lost" && first.verdict != "stuck")) return next_of(first);
  result::RunResult told = first;
  if (first.next_by == "host") {  // no int has exceeded its range
    told.next = result::without_host(first.next);
    told.next_by.clear();
  }
  return fmt::format(
      "{}{}A second run, with checks (--sanitize), has met no signed number that went too high, no bad index "
      "and no division by zero. Not checked: unsigned numbers that wrap, and conversions such as int t = "
      "millis().",
      next_of(told), told.next.empty() ? "" : ". ");
}

}  // namespace

std::string next_after(const result::RunResult& first, const Checked& second) {
  return after_unset(second.unset, next_without_unset(first, second));
}

}  // namespace robosim::campaign
