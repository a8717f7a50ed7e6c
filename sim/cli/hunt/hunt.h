// The hunt itself: worlds are drawn in rounds, what goes wrong in them is grouped by cause and shrunk. What
// is found depends on the seed and the number of runs only, not on how many are made at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "sim/cli/hunt/bench.h"
#include "sim/cli/hunt/finding.h"
#include "sim/cli/hunt/log.h"

namespace robosim::cli {

/// Who hears of it while it goes on.
struct HuntListener {
  std::function<void(const std::string& sentence)> progress;
  /// It was not seen before; whether it is a finding its smallest world says, which is looked for now.
  std::function<void(const Symptom& symptom, std::uint64_t run)> seen;
  std::function<void(const HuntFinding& finding, std::size_t number)> found;
};

class Hunt {
 public:
  Hunt(HuntBench& bench, const HuntArguments& arguments, std::filesystem::path out, HuntLog& log,
       HuntListener listener);

  /// Goes on until enough runs were made, or time is up. False if it was interrupted.
  bool go();
  /// In place of it: takes over what other machines have found, and looks at the whole. False likewise.
  bool merge(const std::vector<HuntPart>& parts);

  const std::vector<HuntFinding>& findings() const { return findings_; }
  std::uint64_t runs() const { return runs_; }
  double simulated_s() const { return simulated_s_; }
  std::size_t traits() const { return traits_.size(); }
  const Plain& plain() const { return plain_; }
  /// What is strange, and no finding: the sketch may wait for what nobody does to it here. Empty = nothing.
  std::string remark() const;
  const HuntWorld& plain_world() const { return plain_world_; }

 private:
  bool find_plain();
  bool make_round();
  bool feel();
  bool hear();
  bool tour();
  std::optional<HuntRow> take(const HuntWorld& world, const wire::RunResult& result,
                              const std::vector<Symptom>& found, const std::vector<std::string>& ran);
  void count(const HuntWorld& world, const HuntRow& row);
  bool add(HuntFinding finding, HuntRow& row);
  bool is_known(const HuntFinding& finding, HuntRow& row) const;
  bool shrink(HuntFinding& finding);
  /// What goes wrong in the worlds; nothing in those that cannot be. False if it was interrupted.
  bool look(const std::vector<HuntWorld>& worlds, std::vector<std::optional<wire::RunResult>>& results,
            std::vector<std::vector<Symptom>>& found, std::vector<std::vector<std::string>>* ran = nullptr);
  std::vector<Symptom> symptoms(const wire::RunResult& result, const HuntWorld& world) const;
  bool has_enough_of(const Symptom& symptom) const;
  bool is_news(const Symptom& symptom, const std::set<std::string>& needs) const;
  void adopt(HuntRow& row, const std::filesystem::path& files);
  void tell(const HuntFinding& finding);
  void look_back();
  double time_of(const HuntWorld& world) const;
  std::uint64_t runs_wanted() const;

  HuntBench& bench_;
  const HuntArguments& arguments_;
  std::filesystem::path out_;
  HuntLog& log_;
  HuntListener listener_;
  Plain plain_;
  HuntWorld plain_world_;
  std::vector<HuntFinding> findings_;
  std::vector<Noted> noted_;
  std::set<std::string> traits_;
  std::uint64_t runs_ = 0;
  std::uint64_t reached_ = 0;    ///< of those that were to reach a goal
  std::set<std::string> heard_;  ///< of what must come sometimes
  double simulated_s_ = 0.0;
  std::int64_t until_us_ = 0;  ///< wall time; 0 = for ever
};

}  // namespace robosim::cli
