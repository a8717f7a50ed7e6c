#include "sim/campaign/check/check_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace robosim::campaign {
namespace {

constexpr std::string_view kDetectedPrefix = "detected: ";

/// Formats a value with enough digits to differ from the limit that it exceeds: "17.23".
std::string beyond(double value, double limit) {
  const std::string text = figure_text(value);
  return text == figure_text(limit) ? fmt::format("{}", value) : text;
}

std::optional<std::string> why_beyond(const FigureLimit& limit, const result::RunResult& result) {
  const std::vector<double> values = limit.figure->values(result);
  if (values.empty()) return fmt::format("{} was not measured in this run", limit.figure->name);
  for (const double value : values) {
    if (limit.max && !(value <= *limit.max)) {
      return fmt::format("{}: expected at most {}, got {}", limit.figure->name, figure_text(*limit.max),
                         beyond(value, *limit.max));
    }
    if (limit.min && !(value >= *limit.min)) {
      return fmt::format("{}: expected at least {}, got {}", limit.figure->name, figure_text(*limit.min),
                         beyond(value, *limit.min));
    }
  }
  return std::nullopt;
}

/// Finds the first of `texts` that does not follow the previous text in `all`. Returns a phrase such as "“b”
/// over its serial port after “a”".
std::optional<std::string> missing_of(const std::vector<std::string>& texts, const std::string& all,
                                      const char* by) {
  std::size_t at = 0;
  std::string after;
  for (const std::string& text : texts) {
    const std::size_t found = all.find(text, at);
    if (found == std::string::npos) return fmt::format("“{}”{}{}", text, by, after);
    at = found + text.size();
    after = fmt::format(" after “{}”", text);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_failed(const Check& check, const result::RunResult& result) {
  if (std::find(check.expect.begin(), check.expect.end(), result.verdict) == check.expect.end()) {
    const std::string wanted = check.expect == std::vector<std::string>{"reached"}
                                   ? ""
                                   : " (expected: " + one_of(check.expect) + ")";
    const bool is_cause =
        !result.next.empty() && result.next_by.empty();  // otherwise `next` only tells how to find the cause
    return fmt::format("{}{}: {}{}", result.verdict, wanted, result.why,
                       is_cause ? " Next: " + result.next + "." : "");
  }
  if (const auto missing = missing_of(check.serial, result.serial, " over its serial port"))
    return fmt::format("the sketch did not send {}", *missing);
  if (const auto missing = missing_of(check.shows, result.shown, ""))
    return fmt::format("no part showed {}", *missing);
  for (const std::string& station : check.stations) {
    const auto& visited = result.metrics.stations;
    if (std::find(visited.begin(), visited.end(), station) == visited.end())
      return fmt::format("the robot did not visit station {}", station);
  }
  std::string broken;
  for (const FigureLimit& limit : check.limits)
    if (const auto why = why_beyond(limit, result)) broken += (broken.empty() ? "" : "; ") + *why;
  if (!broken.empty()) return broken;
  if (!result.detected.empty())
    return fmt::format("{}{} (detect = false turns the detectors off)", kDetectedPrefix,
                       result::text_of(result.detected.front()));
  for (const TextAssertion& assertion : check.assertions)
    if (const std::string why = why_broken(assertion, result); !why.empty()) return why;
  return std::nullopt;
}

bool is_of_detectors(const std::string& why) { return why.rfind(kDetectedPrefix, 0) == 0; }

ExitStatus worse(ExitStatus a, ExitStatus b) {
  constexpr std::array kWorstFirst = {ExitStatus::interrupted, ExitStatus::internal, ExitStatus::tool_missing,
                                      ExitStatus::bad_input,   ExitStatus::failed,   ExitStatus::timeout};
  for (const ExitStatus status : kWorstFirst) {
    if (a == status || b == status) return status;
  }
  return ExitStatus::ok;
}

std::size_t SketchResult::passed() const {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const CheckResult& result) { return result.ok(); }));
}

ExitStatus SketchResult::status() const {
  if (problem) return problem->status;
  ExitStatus status = ExitStatus::ok;
  for (const CheckResult& result : results) status = worse(status, result.status);
  return status;
}

}  // namespace robosim::campaign
