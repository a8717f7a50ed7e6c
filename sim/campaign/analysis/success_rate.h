// Computes success rates: the share of successful runs, and the confidence interval of the true rate. Also
// computes the number of runs needed for a decision.
#pragma once

#include <cstdint>
#include <optional>

namespace robosim::analysis {

struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Returns the 95 % confidence interval of the true rate after `successes` in `runs` runs. Wilson's score
/// interval is
///   (p + z²/2n ± z √(p(1-p)/n + z²/4n²)) / (1 + z²/n)      p = successes / runs, n = runs, z = 1.960
///
/// This interval stays within 0..1. If all runs succeed, it still has a width, whereas p ± z √(p(1-p)/n)
/// claims certainty. Without any runs, the result is 0..1. Source: E. B. Wilson, "Probable inference, the law
/// of succession, and statistical inference", Journal of the American Statistical Association 22 (1927)
/// 209-212.
Interval wilson(std::int64_t successes, std::int64_t runs);

/// A required success rate, for a fixed number of runs.
struct Demand {
  double rate = 1.0;  ///< 0..1
  /// False: at least the share `rate` of the runs must succeed.
  /// True: the lower end of the confidence interval must be at least `rate`. The rate of all possible runs is
  /// then known to be at least `rate`.
  bool sure = false;
};

/// Returns the smallest number of successes in `runs` runs that meets the demand; nullopt if even `runs`
/// successes do not meet it.
std::optional<std::int64_t> needed_successes(const Demand& demand, std::int64_t runs);

/// Returns the smallest number of runs that meets the demand if all of them succeed. Returns nullopt if no
/// number does, as for a rate of 1 that must be `sure`.
std::optional<std::int64_t> needed_runs(const Demand& demand);

/// Counts runs in a fixed order. The tally is decided once the remaining runs cannot change whether the
/// demand is met. Stopping at that point saves runs and never changes the answer, however often the tally is
/// checked. (Stopping as soon as the interval meets the demand would be wrong in more than 5 % of cases.)
class Tally {
 public:
  Tally(std::int64_t planned, std::optional<Demand> demand);

  void add(bool success);

  std::int64_t runs() const { return runs_; }
  std::int64_t successes() const { return successes_; }
  std::int64_t planned() const { return planned_; }
  double rate() const;
  Interval interval() const { return wilson(successes_, runs_); }

  /// Returns whether enough runs have succeeded, whatever the remaining runs do. Returns false without a
  /// demand.
  bool met() const;
  /// Returns whether too many runs have failed, whatever the remaining runs do. Returns false without a
  /// demand.
  bool missed() const;
  bool decided() const { return met() || missed(); }

 private:
  std::int64_t planned_;
  bool demanding_;
  std::int64_t needed_;  ///< if greater than planned_, the demand cannot be met
  std::int64_t runs_ = 0;
  std::int64_t successes_ = 0;
};

}  // namespace robosim::analysis
