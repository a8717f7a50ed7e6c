// Success rates: the share of runs that succeeded, where the true rate may lie, and when enough runs have
// been made to decide.
#pragma once

#include <cstdint>
#include <optional>

namespace robosim::analysis {

struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Returns the interval of the true rate, at 95 % confidence, after `successes` of `runs`: Wilson's score
/// interval,
///   (p + z²/2n ± z √(p(1-p)/n + z²/4n²)) / (1 + z²/n)      p = successes / runs, n = runs, z = 1.960
///
/// It stays within 0..1 and remains meaningful when all runs succeed, where p ± z √(p(1-p)/n) would claim
/// certainty. E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal
/// of the American Statistical Association 22 (1927) 209-212. Without any runs: 0..1.
Interval wilson(std::int64_t successes, std::int64_t runs);

/// The requirement for a fixed number of runs.
struct Demand {
  double rate = 1.0;  ///< 0..1
  /// False: `rate` is the share of exactly these runs that must succeed.
  /// True: these runs must show that the rate of all possible ones is not less; the interval's lower end
  /// counts.
  bool sure = false;
};

/// Returns the smallest number of successes of `runs` that meets the demand; nullopt if not even `runs`
/// would.
std::optional<std::int64_t> needed_successes(const Demand& demand, std::int64_t runs);

/// Returns the smallest number of runs that meets the demand if all of them succeed; nullopt if no number
/// does (a sure rate of 1).
std::optional<std::int64_t> needed_runs(const Demand& demand);

/// Counts runs, in a fixed order. It is decided as soon as the remaining runs can no longer change whether
/// the demand is met. Stopping then saves runs and never changes the answer, however often one checks. (If
/// one stops at a good interval after any run, the result is wrong more often than the interval admits.)
class Tally {
 public:
  Tally(std::int64_t planned, std::optional<Demand> demand);

  void add(bool success);

  std::int64_t runs() const { return runs_; }
  std::int64_t successes() const { return successes_; }
  std::int64_t planned() const { return planned_; }
  double rate() const;
  Interval interval() const { return wilson(successes_, runs_); }

  /// Returns whether enough have succeeded, whatever the others do. Without a demand: never.
  bool met() const;
  /// Returns whether too many have failed, whatever the others do. Without a demand: never.
  bool missed() const;
  bool decided() const { return met() || missed(); }

 private:
  std::int64_t planned_;
  bool demanding_;
  std::int64_t needed_;  ///< more than planned_: cannot be met
  std::int64_t runs_ = 0;
  std::int64_t successes_ = 0;
};

}  // namespace robosim::analysis
