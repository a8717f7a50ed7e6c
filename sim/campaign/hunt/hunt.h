// Runs a hunt: draws test cases in rounds, groups failures by cause, and shrinks the failing test cases. The
// findings depend only on the seed and the number of runs, not on the number of simultaneous runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/campaign/hunt/campaign_runner.h"
#include "sim/campaign/hunt/finding.h"
#include "sim/campaign/hunt/log.h"

namespace robosim::campaign {

/// Receives progress reports.
struct HuntListener {
  std::function<void(const std::string& sentence)> progress;
  /// Called for a new symptom. The search for its smallest test case follows, and decides whether the
  /// symptom is a finding.
  std::function<void(const Symptom& symptom, std::uint64_t run)> seen;
  std::function<void(const HuntFinding& finding, std::size_t number)> found;
};

class Hunt {
 public:
  Hunt(CampaignRunner& campaign, const HuntOptions& options, std::filesystem::path out, HuntLog& log,
       HuntListener listener);

  /// Hunts until enough runs were made, or time is up. Returns false if the user interrupted the hunt.
  bool go();
  /// Alternative to go(): merges the findings of other machines, and evaluates them together. Returns false
  /// if the user interrupted the merge.
  bool merge(const std::vector<HuntPart>& parts);

  const std::vector<HuntFinding>& findings() const { return findings_; }
  std::uint64_t runs() const { return runs_; }
  /// Return the number of runs with a goal, and how many of these runs reached it.
  std::uint64_t runs_with_goal() const { return runs_with_goal_; }
  std::uint64_t runs_that_reached() const { return reached_; }
  /// Returns the number of runs that missed their goal, by verdict.
  const std::map<std::string, std::uint64_t>& runs_that_missed() const { return missed_; }
  double simulated_s() const { return simulated_s_; }
  std::size_t traits() const { return traits_.size(); }
  const Baseline& baseline() const { return baseline_; }
  /// Returns a remark if the sketch controls motors, but no run had a finding or moved the robot; otherwise
  /// "". The sketch may wait for an input that the hunt does not know.
  std::string remark() const;
  const TestCase& plain_world() const { return baseline_case_; }

 private:
  bool find_baseline();
  bool make_round();
  bool feel();
  bool hear();
  bool tour();
  std::optional<HuntRow> take(const TestCase& test_case, const result::RunResult& result,
                              const std::vector<Symptom>& found, const std::vector<std::string>& ran);
  void count(const TestCase& test_case, const HuntRow& row);
  bool add(HuntFinding finding, HuntRow& row);
  bool is_known(const HuntFinding& finding, HuntRow& row) const;
  bool shrink(HuntFinding& finding);
  /// Runs the test cases and sets their symptoms; test cases that the runner refuses have no result. Returns
  /// false if the user interrupted the runs.
  bool look(const std::vector<TestCase>& test_cases, std::vector<std::optional<result::RunResult>>& results,
            std::vector<std::vector<Symptom>>& found, std::vector<std::vector<std::string>>* ran = nullptr);
  std::vector<Symptom> symptoms(const result::RunResult& result, const TestCase& test_case) const;
  bool has_enough_of(const Symptom& symptom) const;
  bool is_news(const Symptom& symptom, const std::set<std::string>& needs) const;
  void adopt(HuntRow& row, const std::filesystem::path& files);
  void tell(const HuntFinding& finding);
  void look_back();
  double time_of(const TestCase& test_case) const;
  std::uint64_t runs_wanted() const;

  CampaignRunner& campaign_;
  const HuntOptions& options_;
  std::filesystem::path out_;
  HuntLog& log_;
  HuntListener listener_;
  Baseline baseline_;
  TestCase baseline_case_;
  std::vector<HuntFinding> findings_;
  std::vector<Noted> noted_;
  std::set<std::string> traits_;
  std::uint64_t runs_ = 0;
  std::uint64_t runs_with_goal_ = 0;
  std::map<std::string, std::uint64_t> missed_;
  std::uint64_t reached_ = 0;    ///< number of runs that reached their goal, among those with a goal
  std::set<std::string> heard_;  ///< texts of `sometimes` assertions that have occurred
  double simulated_s_ = 0.0;
  std::int64_t until_us_ = 0;  ///< wall time of the end; 0 = no limit
};

}  // namespace robosim::campaign
