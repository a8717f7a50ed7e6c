#include "sim/campaign/hunt/hunt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/wall_clock.h"
#include "sim/campaign/hunt/differential_testing.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kAtOnce = 4;      // number of simultaneous test cases while shrinking
constexpr std::size_t kMostTries = 80;  // maximum number of test cases while shrinking a finding
constexpr std::size_t kMostAlike = 5;   // maximum number of findings of one kind of behaviour
constexpr double kBehind_s = 1.0;

}  // namespace

Hunt::Hunt(CampaignRunner& campaign, const HuntOptions& options, std::filesystem::path out, HuntLog& log,
           HuntListener listener)
    : campaign_(campaign),
      options_(options),
      out_(std::move(out)),
      log_(log),
      listener_(std::move(listener)) {
  if (options.minutes > 0.0) until_us_ = wall_us() + static_cast<std::int64_t>(options.minutes * 60e6);
}

std::uint64_t Hunt::runs_wanted() const { return options_.shard.share_of(options_.runs); }

/// Returns the failure first, then detectors' findings, then, in the baseline run, compiler warnings.
std::vector<Symptom> Hunt::symptoms(const result::RunResult& result, const TestCase& test_case) const {
  std::vector<Symptom> all;
  std::vector<Symptom> seen_by_detectors = detected_in(result);
  if (const auto broken = failed_assertion(result, campaign_.space().assertions))
    all.push_back(*broken);
  else if (const auto found = symptom_of(result, test_case, campaign_.space(), baseline_);
           found && (!found->is_behaviour || tells_behaviour(test_case, campaign_.space()))) {
    all.push_back(*found);
    // A verdict says what the robot did. A detector's finding in the same run is often the cause.
    if (found->is_behaviour && !seen_by_detectors.empty())
      all.back().sentence += " Detected: " + seen_by_detectors.front().sentence;
  }
  for (Symptom& seen : seen_by_detectors) all.push_back(std::move(seen));
  if (needs_of(test_case, campaign_.space()).empty())
    for (Symptom& seen : warned_in(campaign_.of(test_case).image.messages)) all.push_back(std::move(seen));
  return all;
}

bool Hunt::look(const std::vector<TestCase>& test_cases,
                std::vector<std::optional<result::RunResult>>& results,
                std::vector<std::vector<Symptom>>& found, std::vector<std::vector<std::string>>* ran) {
  if (!campaign_.run(test_cases, results, ran)) return false;
  found.assign(test_cases.size(), {});
  for (std::size_t i = 0; i < test_cases.size(); ++i)
    if (results[i]) found[i] = symptoms(*results[i], test_cases[i]);
  return run_differential_tests(campaign_, test_cases, results, found);
}

/// Returns whether a symptom would be a new finding.
bool Hunt::is_news(const Symptom& symptom, const std::set<std::string>& needs) const {
  return !has_enough_of(symptom) &&
         std::none_of(findings_.begin(), findings_.end(),
                      [&](const HuntFinding& known) { return known.explains(symptom, needs); });
}

bool Hunt::has_enough_of(const Symptom& symptom) const {
  const auto alike = std::count_if(findings_.begin(), findings_.end(), [&](const HuntFinding& known) {
    return known.symptom.is_behaviour && known.symptom.kind == symptom.kind;
  });
  return symptom.is_behaviour && alike >= static_cast<std::ptrdiff_t>(kMostAlike);
}

bool Hunt::is_known(const HuntFinding& finding, HuntRow& row) const {
  const auto known = std::find_if(findings_.begin(), findings_.end(), [&](const HuntFinding& other) {
    return other.explains(finding.symptom, finding.needs);
  });
  if (known == findings_.end()) return false;
  row.finding = static_cast<std::size_t>(known - findings_.begin()) + 1;
  return true;
}

bool Hunt::add(HuntFinding finding, HuntRow& row) {
  if (is_known(finding, row)) return true;
  if (has_enough_of(finding.symptom)) return true;
  listener_.seen(finding.symptom, row.run);
  if (!shrink(finding)) return false;
  // After shrinking, the finding may equal a known finding.
  if (is_known(finding, row)) return true;
  row.finding = findings_.size() + 1;
  keep(finding, row.finding, campaign_, options_, out_);
  row.fresh = std::move(finding);
  return true;
}

bool Hunt::shrink(HuntFinding& finding) {
  const HuntSpace& space = campaign_.space();
  finding.test_case.family = 0;
  if (finding.symptom.kind != kUnlike) finding.test_case.differential = Differential::none;
  std::size_t tries = 0;
  for (bool smaller_found = true; smaller_found && tries < kMostTries;) {
    smaller_found = false;
    std::vector<TestCase> candidates = smaller(finding.test_case, space);
    for (TestCase& test_case : candidates) test_case.for_s = time_of(test_case);
    for (std::size_t from = 0; from < candidates.size() && !smaller_found && tries < kMostTries;
         from += kAtOnce) {
      const std::size_t to = std::min(candidates.size(), from + kAtOnce);
      const std::vector<TestCase> some(candidates.begin() + static_cast<std::ptrdiff_t>(from),
                                       candidates.begin() + static_cast<std::ptrdiff_t>(to));
      listener_.progress(
          fmt::format("{}: looking for a smaller world, attempt {}", finding.symptom.group, tries + 1));
      std::vector<std::optional<result::RunResult>> results;
      std::vector<std::vector<Symptom>> found;
      if (!look(some, results, found)) return false;
      tries += some.size();
      for (std::size_t i = 0; i < some.size(); ++i) {
        const auto same = std::find_if(found[i].begin(), found[i].end(), [&](const Symptom& one) {
          return one.group == finding.symptom.group;
        });
        if (same == found[i].end()) continue;
        finding.test_case = some[i];
        finding.symptom = *same;
        finding.time_s = results[i]->time_s;
        smaller_found = true;
        break;
      }
    }
  }
  // Prefers the board's chip, if the test case also fails on the chip.
  if (finding.test_case.build == space.host_counterpart) {
    TestCase on_chip = finding.test_case;
    on_chip.build = 0;
    std::vector<std::optional<result::RunResult>> results;
    std::vector<std::vector<Symptom>> found;
    if (!look({on_chip}, results, found)) return false;
    for (const Symptom& one : found.front())
      if (one.group == finding.symptom.group) {
        finding.test_case = on_chip;
        finding.symptom = one;
        finding.time_s = results.front()->time_s;
        break;
      }
  }
  finding.needs = needs_of(finding.test_case, space);
  if (finding.symptom.kind != "late" && finding.symptom.kind != kUnlike) {
    finding.test_case.to_goal = false;
    finding.test_case.for_s = std::ceil(finding.time_s) + kBehind_s;
  }
  return true;
}

void Hunt::tell(const HuntFinding& finding) {
  findings_.push_back(finding);
  listener_.found(findings_.back(), findings_.size());
}

/// Classifies the symptoms of a run. Finds the smallest test case of a new finding. Returns nullopt if the
/// user interrupted the search.
std::optional<HuntRow> Hunt::take(const TestCase& test_case, const result::RunResult& result,
                                  const std::vector<Symptom>& found, const std::vector<std::string>& ran) {
  HuntRow row;
  row.run = runs_;
  row.time_s = result.time_s;
  row.has_goal = test_case.to_goal && result.goal != "none";
  row.reached = row.has_goal && result.verdict == "reached";
  if (row.has_goal && !row.reached) row.missed = result.verdict;
  for (const auto& traits : {traits_of(result), ran})
    for (const std::string& trait : traits)
      if (!traits_.contains(trait) &&
          std::find(row.traits.begin(), row.traits.end(), trait) == row.traits.end())
        row.traits.push_back(trait);
  row.moment = moment_of(row.traits, result);
  for (const std::string& heard : passed_assertions(result, campaign_.space().assertions))
    if (!heard_.contains(heard)) row.heard.push_back(heard);
  const std::set<std::string> needs = needs_of(test_case, campaign_.space());
  const auto news =
      std::find_if(found.begin(), found.end(), [&](const Symptom& one) { return is_news(one, needs); });
  if (!found.empty() &&
      !add({news == found.end() ? found.front() : *news, test_case, needs, result.time_s}, row))
    return std::nullopt;
  return row;
}

void Hunt::count(const TestCase& test_case, const HuntRow& row) {
  ++runs_;
  simulated_s_ += row.time_s;
  if (row.has_goal) ++runs_with_goal_;
  if (row.reached) ++reached_;
  if (!row.missed.empty()) ++missed_[row.missed];
  traits_.insert(row.traits.begin(), row.traits.end());
  heard_.insert(row.heard.begin(), row.heard.end());
  if (!row.traits.empty()) {
    noted_.push_back({test_case, row.moment});
    noted_.back().test_case.family = 0;
  }
  if (row.fresh)
    tell(*row.fresh);
  else if (row.finding > 0 && row.finding <= findings_.size())
    ++findings_[row.finding - 1].times;
}

bool Hunt::make_round() {
  std::vector<TestCase> test_cases, to_make;
  if (runs_ == 0) {
    for (std::size_t build = 0; build < drawn_builds(campaign_.space()); ++build) {
      test_cases.push_back(baseline_case_);
      test_cases.back().build = build;
    }
  } else {
    const std::uint64_t left = runs_wanted() - runs_;
    std::vector<std::uint64_t> runs;
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(kRound, left); ++i)
      runs.push_back(options_.shard.run(runs_ + i));
    test_cases = draw_round(campaign_.space(), noted_, options_.seed, runs);
    for (TestCase& test_case : test_cases) test_case.for_s = time_of(test_case);
  }
  for (std::size_t i = 0; i < test_cases.size(); ++i)
    if (!log_.row(runs_ + i)) to_make.push_back(test_cases[i]);
  std::vector<std::optional<result::RunResult>> results;
  std::vector<std::vector<Symptom>> found;
  std::vector<std::vector<std::string>> ran;
  if (!look(to_make, results, found, &ran)) return false;
  std::size_t made = 0;
  for (const TestCase& test_case : test_cases) {
    const HuntRow* const known = log_.row(runs_);
    if (known) {
      count(test_case, *known);
      continue;
    }
    std::optional<HuntRow> row = results[made] ? take(test_case, *results[made], found[made], ran[made])
                                               : HuntRow{runs_, 0.0, false, {}, {}, {}, 0, {}};
    ++made;
    if (!row) return false;
    log_.add(*row);
    count(test_case, *row);
  }
  listener_.progress(fmt::format("{} of {} runs, {:.0f} s of simulated time, {} finding{}", runs_,
                                 runs_wanted(), simulated_s_, findings_.size(),
                                 findings_.size() == 1 ? "" : "s"));
  return true;
}

/// Checks the requirements that apply to all runs together.
void Hunt::look_back() {
  const auto add_plain = [&](Symptom symptom) {
    HuntFinding finding{std::move(symptom), baseline_case_, {}, baseline_.result.time_s};
    finding.test_case.for_s = std::ceil(baseline_.result.time_s);
    keep(finding, findings_.size() + 1, campaign_, options_, out_);
    tell(finding);
  };
  for (const TextAssertion& assertion : campaign_.space().assertions)
    if (assertion.when == TextAssertion::When::sometimes && !heard_.contains(assertion.text()))
      add_plain({"sometimes", "sometimes " + assertion.text(),
                 fmt::format("This must occur in some run, but did not in any of {} runs: {}.", runs_,
                             assertion.text()),
                 false});
  const result::RunResult& result = baseline_.result;
  // A sketch that does not read the line need not reach a goal. Exception: the user has given a goal.
  const bool has_goal = reads_the_floor(result, baseline_.robot) || !options_.each.request.goal.empty();
  if (!has_goal || reached_ > 0 || !findings_.empty() || result.goal == "none" ||
      result.metrics.distance_m < kMoved_m)
    return;
  add_plain({"goal", "goal",
             runs_ == 0 ? fmt::format("In the first run, the robot did not reach its goal, {}. {}",
                                      result.goal, result.why)
                        : fmt::format("In none of {} runs did the robot reach its goal, {}. {}", runs_,
                                      result.goal, result.why),
             true});
}

std::string Hunt::remark() const {
  if (!findings_.empty() || traits_.contains(kDrives) || !has_motors(baseline_.result, baseline_.robot))
    return "";
  return fmt::format("the robot never drove, with any of the inputs tried; the first run ended so: {}\n",
                     baseline_.result.why);
}

bool Hunt::go() {
  if (!find_baseline()) return false;
  while (runs_ < runs_wanted() && !(options_.stop_early && !findings_.empty()) &&
         (until_us_ == 0 || wall_us() < until_us_))
    if (!make_round()) return false;
  if (options_.shard.whole()) look_back();
  return true;
}

/// Adds a row from another machine's log. The files of the row's finding are in `files`. This hunt may
/// already know the finding.
void Hunt::adopt(HuntRow& row, const fs::path& files) {
  HuntFinding finding = std::move(*row.fresh);
  row.fresh.reset();
  if (is_known(finding, row)) return;
  row.finding = findings_.size() + 1;
  fs::copy(files, out_ / std::to_string(row.finding), fs::copy_options::recursive);
  row.fresh = std::move(finding);
}

bool Hunt::merge(const std::vector<HuntPart>& parts) {
  if (!find_baseline()) return false;
  for (const HuntPart& part : parts) {
    std::vector<std::size_t> ours;  // the numbers that the part's findings have in this hunt
    for (HuntRow row : part.rows) {
      if (row.fresh) {
        adopt(row, part.folder / std::to_string(row.finding));
        ours.push_back(row.finding);
      } else if (row.finding > 0 && row.finding <= ours.size()) {
        row.finding = ours[row.finding - 1];
      }
      count({}, row);
    }
  }
  look_back();
  return true;
}

}  // namespace robosim::campaign
