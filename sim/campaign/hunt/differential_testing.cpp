#include "sim/campaign/hunt/differential_testing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "sim/campaign/analysis/line_text.h"

namespace robosim::campaign {
namespace {

constexpr std::size_t kOften = 20, kFirst = 3, kLongest = 60, kFarMore = 5;
constexpr double kFar = 20.0, kNear = 0.1, kNearBy = 2.0;
constexpr double kDrives_m = 0.3, kStands_m = 0.03;
constexpr int kLater_ms = 37;
constexpr std::int64_t kEarlier_ms = 10 << 16;  // a multiple of 2^16, which does not change a 16-bit clock
constexpr std::uint64_t kOtherSeed = 1009;
constexpr double kLonger = 1.3;

struct Line {
  std::string text;
  analysis::LineText parts;
};

std::vector<Line> lines_of(const std::string& serial) {
  std::vector<Line> lines;
  std::istringstream stream(serial.substr(0, serial.rfind('\n') + 1));  // without an incomplete last line
  for (std::string text; std::getline(stream, text);) {
    while (!text.empty() && text.back() == '\r') text.pop_back();
    if (!text.empty()) lines.push_back({text, analysis::take_apart(text)});
  }
  return lines;
}

/// Removes frequent lines from both runs and returns them by form. They are compared separately, because
/// frequent lines of different forms have no defined order.
std::map<std::string, std::array<std::vector<Line>, 2>> take_frequent(std::vector<Line>& a,
                                                                      std::vector<Line>& b) {
  std::map<std::string, std::array<std::vector<Line>, 2>> all;
  for (const Line& line : a) all[line.parts.form][0].push_back(line);
  for (const Line& line : b) all[line.parts.form][1].push_back(line);
  std::erase_if(
      all, [](const auto& form) { return std::max(form.second[0].size(), form.second[1].size()) <= kOften; });
  const auto is_frequent = [&](const Line& line) { return all.contains(line.parts.form); };
  std::erase_if(a, is_frequent);
  std::erase_if(b, is_frequent);
  return all;
}

std::string says(const std::string& text) {
  return "says “" + (text.size() > kLongest ? text.substr(0, kLongest) + "…" : text) + "”";
}

std::vector<double> values_of(const Line& line) {
  std::vector<double> values;
  for (const analysis::Number& number : line.parts.numbers) values.push_back(number.value);
  return values;
}

bool is_like(double a, double b) {
  return std::fabs(a - b) <= kFar || (a * b > 0.0 && std::max(a / b, b / a) <= 2.0);
}

bool is_near(double x, double y) {
  return std::fabs(x - y) <= kNearBy + kNear * std::max(std::fabs(x), std::fabs(y));
}

std::optional<Divergence> divergence(const std::vector<Line>& a, const std::vector<Line>& b, bool numbers) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i >= a.size())
      return Divergence{"prints nothing at that point", says(b[i].text), "|" + b[i].parts.form, {}, {}};
    if (i >= b.size())
      return Divergence{says(a[i].text), "prints nothing at that point", a[i].parts.form + "|", {}, {}};
    if (a[i].parts.form != b[i].parts.form)
      return Divergence{says(a[i].text), says(b[i].text), a[i].parts.form + "|" + b[i].parts.form, {}, {}};
    const std::vector<double> x = values_of(a[i]), y = values_of(b[i]);
    if (numbers && std::equal(x.begin(), x.end(), y.begin(), y.end(), is_like)) continue;
    if (numbers) return Divergence{says(a[i].text), says(b[i].text), a[i].parts.form, x, y};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Divergence> divergence(const result::RunResult& ours, const result::RunResult& other,
                                     bool numbers) {
  std::vector<Line> a = lines_of(ours.serial), b = lines_of(other.serial);
  const auto frequent = take_frequent(a, b);
  if (auto found = divergence(a, b, numbers)) return found;
  for (auto [form, lines] : frequent) {
    const std::size_t both = std::min(lines[0].size(), lines[1].size());
    const std::size_t most = std::max(lines[0].size(), lines[1].size());
    if (!numbers && both > 0 && most > kFarMore * both) {
      const auto times = [&](const std::vector<Line>& side) {
        return fmt::format("{} {} time{}", says(side.front().text), side.size(), side.size() == 1 ? "" : "s");
      };
      return Divergence{
          times(lines[0]), times(lines[1]), form + (lines[0].size() == most ? "|more" : "|less"), {}, {}};
    }
    if (both > 0)
      for (auto& side : lines) side.resize(std::min(both, kFirst));
    if (auto found = divergence(lines[0], lines[1], numbers)) return found;
  }
  const double far = ours.metrics.distance_m, near = other.metrics.distance_m;
  if (far > kDrives_m && near < kStands_m) return Divergence{"drives", "stands", "drives|stands", {}, {}};
  if (near > kDrives_m && far < kStands_m) return Divergence{"stands", "drives", "stands|drives", {}, {}};
  return std::nullopt;
}

bool is_same(const Divergence& a, const Divergence& b) {
  if (a.form != b.form || a.of_ours.size() != b.of_ours.size()) return false;
  for (std::size_t i = 0; i < a.of_ours.size(); ++i)
    if (!is_like(a.of_ours[i], a.of_other[i]) &&
        !(is_near(a.of_ours[i], b.of_ours[i]) && is_near(a.of_other[i], b.of_other[i])))
      return false;
  return true;
}

TestCase counterpart_of(const TestCase& test_case, const HuntSpace& space) {
  TestCase differential = test_case;
  if (test_case.differential == Differential::host) differential.build = *space.host_counterpart;
  // Starts the clock earlier, so that it does not wrap. Starts it no earlier than kPast_ms, when all one-time
  // actions after power-on are past.
  differential.clock_ms = test_case.differential == Differential::clock
                              ? std::max(kPast_ms, test_case.clock_ms - kEarlier_ms)
                              : 0;
  return differential;
}

TestCase tried_again(const TestCase& test_case, const HuntSpace& space, int time) {
  TestCase again = test_case;
  again.seed += kOtherSeed * static_cast<std::uint64_t>(time);
  const std::vector<Stimulus> opening = opening_of(test_case, space);
  for (Stimulus& stimulus : again.stimuli)
    if (std::find(opening.begin(), opening.end(), stimulus) == opening.end())
      stimulus.at_ms += kLater_ms * time;
  again.for_s = std::ceil(kLonger * test_case.for_s);
  return again;
}

Symptom symptom_of(const Divergence& divergence, const TestCase& test_case, const HuntSpace& space) {
  const std::string& target = space.builds[test_case.build].target;
  if (test_case.differential == Differential::host)
    return {kUnlike, "unlike the host " + divergence.form,
            fmt::format("The host {}, but the {} {}; noise is not the reason.", divergence.other, target,
                        divergence.ours),
            false};
  return {kUnlike, "unlike when its clock wraps " + divergence.form,
          fmt::format(
              "If millis() is near an overflow, the sketch {}; some minutes earlier it {}. Noise is not the "
              "reason.",
              divergence.ours, divergence.other),
          false};
}

bool run_differential_tests(CampaignRunner& campaign, const std::vector<TestCase>& test_cases,
                            const std::vector<std::optional<result::RunResult>>& results,
                            std::vector<std::vector<Symptom>>& found) {
  std::vector<std::size_t> pairs;
  std::vector<TestCase> counterparts;
  for (std::size_t i = 0; i < test_cases.size(); ++i)
    if (test_cases[i].differential != Differential::none && results[i] && found[i].empty()) {
      pairs.push_back(i);
      counterparts.push_back(counterpart_of(test_cases[i], campaign.space()));
    }
  std::vector<std::optional<result::RunResult>> others;
  if (!campaign.run(counterparts, others)) return false;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const TestCase& test_case = test_cases[pairs[p]];
    const bool numbers = test_case.differential == Differential::host;
    if (!others[p]) continue;
    const std::optional<Divergence> first = divergence(*results[pairs[p]], *others[p], numbers);
    if (!first) continue;
    std::vector<TestCase> again;
    for (int time = 1; time <= kTriedAgain; ++time) {
      again.push_back(tried_again(test_case, campaign.space(), time));
      again.push_back(counterpart_of(again.back(), campaign.space()));
    }
    std::vector<std::optional<result::RunResult>> tried;
    if (!campaign.run(again, tried)) return false;
    bool always = true;
    for (std::size_t i = 0; i < tried.size(); i += 2) {
      const auto next =
          tried[i] && tried[i + 1] ? divergence(*tried[i], *tried[i + 1], numbers) : std::nullopt;
      always = always && next && is_same(*first, *next);
    }
    if (always) found[pairs[p]].push_back(symptom_of(*first, test_case, campaign.space()));
  }
  return true;
}

}  // namespace robosim::campaign
