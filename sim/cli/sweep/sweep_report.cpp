#include "sim/cli/sweep/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/terminal_text.h"
#include "sim/view/terminal/text.h"

namespace robosim::cli {
namespace {

constexpr std::size_t kFailuresShown = 3;

// Round a share to four digits, down or up. share_down() never shows a share below 1 as 1, and share_up()
// never shows a share above 0 as 0.
std::string share_down(double share) { return fmt::format("{:.4f}", std::floor(share * 1e4) / 1e4); }
std::string share_up(double share) { return fmt::format("{:.4f}", std::ceil(share * 1e4) / 1e4); }

using Lines = std::vector<std::vector<std::string>>;

/// Aligns columns by their widths: the first `left` columns to the left, the others to the right.
std::string aligned(const Lines& lines, std::size_t left) {
  std::vector<int> widths(lines[0].size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], terminal::width_of(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string space(static_cast<std::size_t>(widths[i] - terminal::width_of(line[i])), ' ');
      row += (i == 0 ? "" : "  ") + (i < left ? line[i] + space : space + line[i]);
    }
    text += row + "\n";
  }
  return text;
}

// The minimum, mean and maximum score of the runs that have a score.
struct Scores {
  double least = 0.0, sum = 0.0, most = 0.0;
  int count = 0;

  void add(double score) {
    least = count == 0 ? score : std::min(least, score);
    most = count == 0 ? score : std::max(most, score);
    sum += score;
    ++count;
  }
  void add(const Scores& other) {
    if (other.count == 0) return;
    least = count == 0 ? other.least : std::min(least, other.least);
    most = count == 0 ? other.most : std::max(most, other.most);
    sum += other.sum;
    count += other.count;
  }
  std::string text() const {
    return count == 0 ? "-" : fmt::format("{:.2f} .. {:.2f} .. {:.2f}", least, sum / count, most);
  }
};

// The numbers of a line of the table.
struct Counts {
  std::int64_t runs = 0, successes = 0;
  double reached_time_s = 0.0;  // sum over the successful runs
  Scores scores;

  void add(const Counts& other) {
    runs += other.runs;
    successes += other.successes;
    reached_time_s += other.reached_time_s;
    scores.add(other.scores);
  }
};

std::vector<std::string> line_of(const std::vector<std::string>& names, const Counts& counts, bool scored) {
  std::vector<std::string> line;
  for (const std::string& name : names) line.push_back(in_one_line(name));
  line.push_back(std::to_string(counts.runs));
  line.push_back(std::to_string(counts.successes));
  const auto runs = static_cast<double>(counts.runs), successes = static_cast<double>(counts.successes);
  const analysis::Interval interval = analysis::wilson(counts.successes, counts.runs);
  line.push_back(counts.runs == 0 ? "-" : share_down(successes / runs));
  line.push_back(counts.runs == 0 ? "-" : share_down(interval.low) + " .. " + share_up(interval.high));
  line.push_back(counts.successes == 0 ? "-" : fmt::format("{:.2f} s", counts.reached_time_s / successes));
  if (scored) line.push_back(counts.scores.text());
  return line;
}

// Returns a line of totals for each sketch that has several combinations.
Lines totals(const campaign::SweepPlan& plan, const std::vector<Counts>& counts, bool scored) {
  std::vector<std::string> sketches;  // in the table's order
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < plan.combinations.size(); ++i) {
    const std::string& sketch = plan.combinations[i].title;
    if (places[sketch].empty()) sketches.push_back(sketch);
    places[sketch].push_back(i);
  }
  Lines lines;
  for (const std::string& sketch : sketches) {
    const std::vector<std::size_t>& own = places[sketch];
    if (own.size() < 2) continue;
    Counts total;
    for (const std::size_t i : own) total.add(counts[i]);
    const auto common = [&](std::string launch::RunInputs::*name) {
      const std::string& first = plan.combinations[own[0]].inputs.*name;
      const bool equal = std::all_of(
          own.begin(), own.end(), [&](std::size_t i) { return plan.combinations[i].inputs.*name == first; });
      return equal ? first : std::string("all");
    };
    lines.push_back(line_of({sketch, common(&launch::RunInputs::map), common(&launch::RunInputs::robot),
                             common(&launch::RunInputs::target)},
                            total, scored));
  }
  return lines;
}

/// Lists the failures, with commands that repeat the first failures.
std::string failures_text(const campaign::SweepPlan& plan, std::size_t combination,
                          const analysis::Tally& tally, const std::vector<std::size_t>& failures,
                          const std::vector<campaign::SweepOutcome>& outcomes) {
  if (failures.empty()) return "";
  const campaign::Combination& c = plan.combinations[combination];
  std::map<std::string, int> verdicts;
  for (const std::size_t run : failures) ++verdicts[outcomes[run].verdict];
  std::string kinds;
  for (const auto& [verdict, times] : verdicts)
    kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", times, verdict);
  std::string text = fmt::format("\n{}: {} of {} did not reach the goal ({})\n", in_one_line(c.text()),
                                 failures.size(), tally.runs(), kinds);
  for (std::size_t i = 0; i < std::min(failures.size(), kFailuresShown); ++i) {
    const campaign::SweepOutcome& outcome = outcomes[failures[i]];
    const std::uint64_t seed = plan.seed_of(failures[i]);
    text += fmt::format("  seed {}: {}. {}\n    {}\n", seed, outcome.verdict, in_one_line(outcome.why),
                        in_one_line(campaign::replay_command(c, seed)));
  }
  if (failures.size() > kFailuresShown)
    text += fmt::format("  and {} more\n", failures.size() - kFailuresShown);
  return text;
}

/// Reports whether the success rate meets --min-rate, if enough runs were made to decide. Adds a hint if the
/// rate is met, but the runs do not prove it in general.
std::string demand_text(const campaign::SweepOptions& options, const campaign::SweepPlan& plan,
                        const std::vector<analysis::Tally>& tallies) {
  const analysis::Demand demand = *campaign::demand_of(options);
  std::string text;
  bool doubtful = false;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const analysis::Tally& tally = tallies[i];
    const std::string name = plan.combinations[i].text();
    if (!tally.decided()) continue;
    if (tally.missed()) {
      text +=
          fmt::format("--min-rate {}: not met by {}: {} of {} reached the goal, and {} of {} are needed\n",
                      demand.rate, name, tally.successes(), tally.runs(),
                      *analysis::needed_successes(demand, tally.planned()), tally.planned());
    }
    if (options.stop_early && tally.runs() < tally.planned()) {
      text += fmt::format("{}: stopped after {} of {} runs; the other runs could not change that it is {}\n",
                          name, tally.runs(), tally.planned(), tally.met() ? "met" : "not met");
    }
    doubtful = doubtful || (tally.met() && tally.interval().low < demand.rate);
  }
  if (!std::all_of(tallies.begin(), tallies.end(), [](const analysis::Tally& t) { return t.met(); }))
    return text.empty() ? "" : "\n" + text;
  text += fmt::format("--min-rate {}: met\n", demand.rate);
  if (doubtful && !demand.sure) {
    const auto needed = analysis::needed_runs({demand.rate, true});
    text += fmt::format(
        "These runs have that rate, but they do not prove it in general, because the interval begins below "
        "it.{}\n",
        needed ? fmt::format(" {} seeds without a failure would prove it (--sure demands this).", *needed)
               : "");
  }
  return "\n" + text;
}

}  // namespace

std::string sweep_report(const campaign::SweepOptions& options, const campaign::SweepPlan& plan,
                         const std::vector<campaign::SweepOutcome>& outcomes) {
  Lines lines{{"sketch", "map", "robot", "target", "runs", "reached", "rate", "95 % interval", "mean time"}};
  const bool scored =
      std::any_of(outcomes.begin(), outcomes.end(),
                  [](const campaign::SweepOutcome& outcome) { return !std::isnan(outcome.score); });
  if (scored) lines[0].push_back("score: least, mean, most");
  std::vector<analysis::Tally> tallies;
  std::vector<Counts> counts;
  std::string failed;
  for (std::size_t i = 0; i < plan.combinations.size(); ++i) {
    std::vector<std::size_t> failures;
    Counts of;
    tallies.push_back(campaign::count_runs_of(i, options, plan, outcomes, [&](std::size_t run) {
      if (outcomes[run].reached()) {
        of.reached_time_s += outcomes[run].time_s;
      } else {
        failures.push_back(run);
      }
      if (!std::isnan(outcomes[run].score)) of.scores.add(outcomes[run].score);
    }));
    of.runs = tallies.back().runs();
    of.successes = tallies.back().successes();
    const campaign::Combination& c = plan.combinations[i];
    lines.push_back(line_of({c.title, c.inputs.map, c.inputs.robot, c.inputs.target}, of, scored));
    counts.push_back(of);
    failed += failures_text(plan, i, tallies.back(), failures, outcomes);
  }
  if (!options.stop_early) {  // an early stop gives some combinations fewer runs than others
    const Lines sums = totals(plan, counts, scored);
    lines.insert(lines.end(), sums.begin(), sums.end());
  }
  constexpr std::size_t kNames = 4;
  return aligned(lines, kNames) + failed + (options.min_rate ? demand_text(options, plan, tallies) : "");
}

}  // namespace robosim::cli
