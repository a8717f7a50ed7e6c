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

namespace robosim::cli {

/// Who hears of it while it goes on.
struct HuntListener {
  std::function<void(const std::string& sentence)> progress;
  std::function<void(const HuntFinding& finding, std::size_t number)> found;
};

class Hunt {
 public:
  Hunt(HuntBench& bench, const HuntArguments& arguments, std::filesystem::path out, HuntListener listener);

  /// Goes on until enough runs were made, or time is up. False if it was interrupted.
  bool go();

  const std::vector<HuntFinding>& findings() const { return findings_; }
  std::uint64_t runs() const { return runs_; }
  double simulated_s() const { return simulated_s_; }
  std::size_t traits() const { return traits_.size(); }
  const Plain& plain() const { return plain_; }
  const HuntWorld& plain_world() const { return plain_world_; }

 private:
  bool find_plain();
  bool make_round();
  bool take(const HuntWorld& world, const wire::RunResult& result);
  bool shrink(HuntFinding& finding);
  bool add(HuntFinding finding);
  void note(const HuntWorld& world, const wire::RunResult& result);
  bool tell_if_no_goal();
  double time_of(const HuntWorld& world) const;

  HuntBench& bench_;
  const HuntArguments& arguments_;
  std::filesystem::path out_;
  HuntListener listener_;
  Plain plain_;
  HuntWorld plain_world_;
  std::vector<HuntFinding> findings_;
  std::vector<HuntWorld> noted_;
  std::set<std::string> traits_;
  std::uint64_t runs_ = 0;
  std::uint64_t reached_ = 0;  ///< of those that were to reach a goal
  double simulated_s_ = 0.0;
  std::int64_t until_us_ = 0;  ///< wall time; 0 = for ever
};

}  // namespace robosim::cli
