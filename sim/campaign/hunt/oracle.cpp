#include "sim/campaign/hunt/oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>

namespace robosim::campaign {
namespace {

constexpr double kPatience = 4.0, kPause_s = 20.0;
constexpr std::size_t kMostSent = 200;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Replaces each number by one #.
std::string without_numbers(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (!is_digit(c))
      plain += c;
    else if (plain.empty() || plain.back() != '#')
      plain += '#';
  return plain;
}

constexpr const char* kSerial = "serial ";
constexpr std::size_t kLineBegins = 60;

std::string line_trait(const char* way, const std::string& line) {
  return way + without_numbers(line).substr(0, kLineBegins);
}

/// Returns whether an event results from the robot's actions, not from a stimulus.
bool is_robots(const std::string& event) {
  for (const char* const begin : {"station ", "lap ", "collision "})
    if (event.starts_with(begin)) return true;
  const bool was_done = event.starts_with("fault") || event.starts_with("\"");
  return !was_done && event.find(": ") != std::string::npos;  // reported by a part or the rules
}

std::string place_of(const result::Crash& crash) {
  if (crash.where.file.empty()) return "";
  return fmt::format("{}:{}", crash.where.file, crash.where.line);
}

Symptom crashed(const result::RunResult& result) {
  const result::Crash& crash = *result.crash;
  const std::string place = place_of(crash);
  if (crash.check.starts_with("torn_") || crash.check == "lost_update")  // detectors report these, too
    return {"crashed", crash.check + " " + place, result.why, false};
  return {"crashed", fmt::format("{} {}", place.empty() ? without_numbers(crash.reason) : "crashed", place),
          result.why, false};
}

bool is_undisturbed(const TestCase& test_case, const HuntSpace& space) {
  std::vector<Stimulus> stimuli = test_case.stimuli;
  std::erase_if(stimuli, [](const Stimulus& stimulus) { return stimulus.kind == kUsedEeprom; });
  return test_case.faults.faults.empty() && stimuli == opening_of(test_case, space);
}

}  // namespace

bool has_motors(const result::RunResult& result, const wire::RobotInfo& robot) {
  const auto& unused = result.usage.unused;
  return std::any_of(robot.parts.begin(), robot.parts.end(), [&](const auto& part) {
    return part.type == "motor" && std::find(unused.begin(), unused.end(), part.name) == unused.end();
  });
}

bool reads_the_floor(const result::RunResult& result, const wire::RobotInfo& robot) {
  const auto& unused = result.usage.unused;
  return std::any_of(robot.sensors.begin(), robot.sensors.end(), [&](const wire::RobotInfo::Sensor& sensor) {
    return std::find(unused.begin(), unused.end(), sensor.name) == unused.end();
  });
}

double longest_wait_s(const TestCase& test_case, const HuntSpace& space, const Baseline& baseline) {
  const double pause_s = kPause_s + test_case.later_ms / 1000.0;
  if (!test_case.drawn()) return test_case.map == 0 ? pause_s + kPatience * baseline.result.time_s : 0.0;
  const double way_m = line_length_m(test_case, space) * (test_case.track ? 1.0 : 2.0);
  return baseline.speed_m_s() > 0.0 ? pause_s + kPatience * way_m / baseline.speed_m_s() : 0.0;
}

bool tells_behaviour(const TestCase& test_case, const HuntSpace& space) {
  return !space.builds[test_case.build].checked && (!test_case.network || space.maps[test_case.map].tours) &&
         std::none_of(test_case.stimuli.begin(), test_case.stimuli.end(), [](const Stimulus& stimulus) {
           return stimulus.kind == kPowerOff || stimulus.kind == kHeld || stimulus.kind == kTwisted;
         });
}

std::optional<Symptom> symptom_of(const result::RunResult& result, const TestCase& test_case,
                                  const HuntSpace& space, const Baseline& baseline) {
  const std::string& verdict = result.verdict;
  if (verdict == "crashed" && result.crash) return crashed(result);
  if (verdict == "hung" || verdict == "over_budget") return Symptom{verdict, verdict, result.why, false};
  const bool behaves = verdict == "stuck" || verdict == "toppled" ||
                       (verdict == "lost" && reads_the_floor(result, baseline.robot));
  if (behaves) return Symptom{verdict, verdict, result.why, true};
  const bool was_blocked = std::any_of(test_case.stimuli.begin(), test_case.stimuli.end(),
                                       [](const Stimulus& stimulus) { return stimulus.kind == kObstacle; });
  if (result.metrics.collisions > 0 && !was_blocked && baseline.result.metrics.collisions == 0)
    return Symptom{
        "collision", "collision",
        fmt::format("The robot ran into something {} in {:.2f} s, but not in the baseline run.",
                    result.metrics.collisions == 1 ? std::string("once")
                                                   : fmt::format("{} times", result.metrics.collisions),
                    result.time_s),
        true};
  if (verdict == "timeout" && test_case.to_goal && baseline.reached() && is_undisturbed(test_case, space)) {
    const double limit = longest_wait_s(test_case, space, baseline);
    if (limit > 0.0 && result.time_s >= limit) return Symptom{"late", "late", result.why, true};
  }
  return std::nullopt;
}

std::vector<Symptom> detected_in(const result::RunResult& result) {
  std::vector<Symptom> all;
  for (const result::Detected& seen : result.detected) {
    std::string sentence = result::text_of(seen);
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    const std::string place =
        seen.where.file.empty() ? "" : fmt::format(" {}:{}", seen.where.file, seen.where.line);
    all.push_back({kDetected, seen.detector + place, sentence, false});
  }
  return all;
}

std::vector<Symptom> warned_in(const std::string& messages) {
  static const std::regex kWarning(
      R"(^([^\s:]+):(\d+):(?:\d+:)? warning: (.*) \[-W(parentheses|empty-body|overflow|div-by-zero|array-bounds|shift-count-overflow|shift-count-negative|return-local-addr|sizeof-pointer-memaccess|maybe-uninitialized)=?\]$)");
  std::vector<Symptom> all;
  std::istringstream stream(messages);
  for (std::string line; std::getline(stream, line);) {
    std::smatch parts;
    if (!std::regex_match(line, parts, kWarning)) continue;
    const std::string place = fmt::format("{}:{}", parts.str(1), parts.str(2)),
                      group = kWarned + (" " + place);
    if (std::none_of(all.begin(), all.end(), [&](const Symptom& known) { return known.group == group; }))
      all.push_back({kWarned, group, fmt::format("The compiler warns: {}, {}.", parts.str(3), place), false});
  }
  return all;
}

std::optional<Symptom> failed_assertion(const result::RunResult& result,
                                        const std::vector<TextAssertion>& assertions) {
  // A run that ended early cannot have broken an `always` assertion.
  const bool whole = result.verdict == "reached" || result.verdict == "timeout" || result.verdict == "ended";
  for (const TextAssertion& assertion : assertions) {
    if (assertion.when == TextAssertion::When::always && !whole) continue;
    std::string why = why_broken(assertion, result);
    if (why.empty()) continue;
    why[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(why[0])));
    const char* const kind = assertion.when == TextAssertion::When::never ? "never" : "always";
    return Symptom{kind, fmt::format("{} {}", kind, assertion.text()), why + ".", false};
  }
  return std::nullopt;
}

std::vector<std::string> passed_assertions(const result::RunResult& result,
                                           const std::vector<TextAssertion>& assertions) {
  std::vector<std::string> kept;
  for (const TextAssertion& assertion : assertions)
    if (assertion.when == TextAssertion::When::sometimes && assertion.is_in(result))
      kept.push_back(assertion.text());
  return kept;
}

Moment moment_of(const std::vector<std::string>& traits, const result::RunResult& result) {
  const auto is_new = [&](const std::string& trait) {
    return std::find(traits.begin(), traits.end(), trait) != traits.end();
  };
  for (const result::RunResult::Entry& event : result.events)
    if (is_robots(event.text) && is_new("event " + without_numbers(event.text)))
      return {static_cast<int>(std::lround(1000.0 * event.t_s)), {}};
  std::istringstream stream(result.serial);
  for (std::string line; std::getline(stream, line);) {
    const std::string begins = line.substr(0, line.find_first_of("0123456789\r"));
    if (!begins.empty() && is_new(line_trait(kSerial, line))) return {-1, begins};
  }
  return {};
}

std::vector<std::string> traits_of(const result::RunResult& result) {
  std::vector<std::string> traits{
      "verdict " + result.verdict, fmt::format("stations {}", result.metrics.stations.size()),
      fmt::format("laps {}", result.metrics.laps_s.size()),
      fmt::format("collisions {}", std::min(result.metrics.collisions, 3)),
      fmt::format("writes {}",
                  result.eeprom_writes == 0 ? 0 : static_cast<int>(std::log2(result.eeprom_writes)) + 1)};
  for (const result::RunResult::Entry& event : result.events)
    if (is_robots(event.text)) traits.push_back("event " + without_numbers(event.text));
  if (result.metrics.distance_m > kMoved_m) traits.push_back(kDrives);
  std::size_t lines = 0;
  for (const auto& [name, text] : {std::pair{kSerial, &result.serial}, {"shown ", &result.shown}}) {
    std::istringstream stream(*text);
    for (std::string line; lines < kMostSent && std::getline(stream, line); ++lines)
      traits.push_back(line_trait(name, line));
  }
  return traits;
}

}  // namespace robosim::campaign
