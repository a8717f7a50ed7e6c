// Finds the baseline run, which has no disturbance, and derives the sketch's purpose from that run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/campaign/hunt/hunt.h"
#include "sim/campaign/hunt/stimuli.h"

namespace robosim::campaign {
namespace {

constexpr double kLongest_s = 300.0, kAfter_s = 20.0;
constexpr double kWayAgain = 1.5, kWayOn_s = 15.0;  // limit of most runs: baseline's time * factor + time
constexpr double kSlower = 5.0;
constexpr std::size_t kTours = 4, kEnoughTours = 2;

bool reached(const std::optional<result::RunResult>& result) {
  return result && result->verdict == "reached";
}

}  // namespace

double Hunt::time_of(const TestCase& test_case) const {
  double usual = (span_ms(test_case, campaign_.space()) + test_case.later_ms) / 1000.0;
  const bool waits = std::any_of(test_case.stimuli.begin(), test_case.stimuli.end(),
                                 [](const Stimulus& stimulus) { return !stimulus.after.empty(); });
  if (waits && baseline_.reached()) usual = std::min(kLongest_s, usual + baseline_.result.time_s);
  if (!test_case.to_goal || !baseline_.reached()) return usual;
  const double limit = std::ceil(longest_wait_s(test_case, campaign_.space(), baseline_));
  return limit > kLongest_s ? usual : std::max(limit, usual);
}

bool Hunt::find_baseline() {
  listener_.progress("recording the baseline run …");
  const std::vector<std::vector<Stimulus>> ways = openings(campaign_.space());
  std::vector<TestCase> test_cases;
  for (std::size_t map = 0; map < (campaign_.maps_are_given() ? 1 : campaign_.space().maps.size()); ++map)
    for (const std::vector<Stimulus>& way : ways) {
      TestCase& test_case = test_cases.emplace_back();
      test_case.map = map;
      test_case.stimuli = way;
      test_case.for_s = campaign_.space().for_ms / 1000.0;
    }
  std::vector<std::optional<result::RunResult>> results;
  if (!campaign_.run(test_cases, results)) return false;
  if (std::none_of(results.begin(), results.end(), reached)) {
    // Gives more time to robots that have not arrived yet.
    std::vector<TestCase> slow;
    for (std::size_t i = 0; i < test_cases.size(); ++i)
      if (results[i] && results[i]->verdict == "timeout" && results[i]->metrics.distance_m > kMoved_m) {
        slow.push_back(test_cases[i]);
        slow.back().for_s = kSlower * test_cases[i].for_s;
      }
    std::vector<std::optional<result::RunResult>> later;
    if (!campaign_.run(slow, later)) return false;
    if (std::any_of(later.begin(), later.end(), reached)) test_cases = slow, results = later;
  }
  const auto is_better = [](const result::RunResult& a, const result::RunResult& b) {
    if ((a.verdict == "reached") != (b.verdict == "reached")) return a.verdict == "reached";
    return b.metrics.distance_m < kMoved_m && a.metrics.distance_m > kMoved_m;
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < test_cases.size(); ++i)
    if (results[i] && (!best || is_better(*results[i], *results[*best]))) best = i;
  if (!best) throw InputError(campaign_.refusal());
  baseline_ = {*results[*best], campaign_.robot()};
  baseline_case_ = test_cases[*best];
  if (!campaign_.maps_are_given()) {
    // Keeps all maps on which the robot reaches its goal without more collisions than in the baseline run.
    std::vector<std::size_t> kept{baseline_case_.map};
    for (std::size_t i = 0; i < test_cases.size(); ++i)
      if (reached(results[i]) && results[i]->metrics.collisions <= baseline_.result.metrics.collisions &&
          std::find(kept.begin(), kept.end(), test_cases[i].map) == kept.end())
        kept.push_back(test_cases[i].map);
    campaign_.keep_maps(kept);
  }
  HuntSpace& space = campaign_.space();
  space.usual_ms = space.for_ms;
  if (baseline_.reached())
    space.usual_ms =
        std::min(space.for_ms, static_cast<int>(1000.0 * (kWayAgain * baseline_.result.time_s + kWayOn_s)));
  baseline_case_.map = 0;
  campaign_.space().opening = baseline_case_.stimuli;
  baseline_case_.for_s = time_of(baseline_case_);
  return feel() && hear() && tour();
}

/// Finds out whether the sketch uses a bumper, by pressing the bumper. A read of its pin proves nothing,
/// because a read of the whole port includes the pin.
bool Hunt::feel() {
  const auto& unused = baseline_.result.usage.unused;
  std::vector<TestCase> pressed;
  for (const auto& part : campaign_.robot().parts) {
    if (part.type != "bumper" || std::find(unused.begin(), unused.end(), part.name) != unused.end()) continue;
    TestCase& test_case = pressed.emplace_back(baseline_case_);
    test_case.stimuli.push_back({static_cast<int>(500.0 * baseline_.result.time_s),
                                 fmt::format("fault {} pressed for 2s", part.name), "press " + part.name});
  }
  if (!pressed.empty()) pressed.push_back(baseline_case_);
  std::vector<std::optional<result::RunResult>> results;
  if (!campaign_.run(pressed, results)) return false;
  for (std::size_t i = 0; i + 1 < results.size(); ++i)
    if (results[i] && results.back() && results[i]->trace_hash != results.back()->trace_hash)
      campaign_.space().feels = true;
  return true;
}

/// Records the lines that the sketch prints, also after the goal. Test cases may send messages after these
/// lines.
bool Hunt::hear() {
  if (!hears(campaign_.space())) return true;
  TestCase test_case = baseline_case_;
  test_case.to_goal = false;
  test_case.for_s = std::max(test_case.for_s, std::ceil(baseline_.result.time_s) + kAfter_s);
  std::vector<std::optional<result::RunResult>> results;
  if (!campaign_.run({test_case}, results)) return false;
  if (results.front()) campaign_.space().said = beginnings_of(results.front()->serial);
  return true;
}

/// Finds out on which kinds of maps the sketch reliably reaches its goal. A loop follower that turns at a
/// line's end may visit all stations of a single map by luck.
bool Hunt::tour() {
  HuntSpace& space = campaign_.space();
  for (std::size_t map = 1; map < space.maps.size() && !campaign_.maps_are_given() && space.draws_maps;
       ++map) {
    if (!space.maps[map].networks) continue;
    std::vector<TestCase> test_cases = networks_like(space, map, options_.seed, kTours);
    for (TestCase& test_case : test_cases) test_case.for_s = time_of(test_case);
    std::vector<std::optional<result::RunResult>> results;
    if (!campaign_.run(test_cases, results)) return false;
    space.maps[map].tours =
        static_cast<std::size_t>(std::count_if(results.begin(), results.end(), reached)) >= kEnoughTours;
  }
  return true;
}

}  // namespace robosim::campaign
