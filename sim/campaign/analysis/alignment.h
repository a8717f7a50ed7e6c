// Aligns the times of two histories by common events: places and lines that both histories contain
// (compare.h).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/analysis/history.h"

namespace robosim::analysis {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kNear_ns = kSecond_ns;  ///< maximum time between events that count as simultaneous
/// This share of the time to the nearest common event is added to kNear_ns. One board may be 0.5 % fast, and
/// another of the same kind 0.5 % slow (an Uno's resonator, Murata CSTCE16M0V53).
constexpr std::int64_t kApart_percent = 1;

/// Returns the end of the comparable behaviour: the loss of the line, otherwise the end of the run.
std::int64_t seen_ns(const History& history);

/// Returns "1.234 s".
std::string seconds(std::int64_t ns);

/// Converts times of one side to times of the other side, by linear interpolation between common events.
class Clocks {
 public:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  /// Adds the times of a common event on the two sides, ns. finish() adds the start of the runs.
  void add(std::int64_t a, std::int64_t b) { pairs_.emplace_back(a, b); }
  /// Prepares the conversions; call this after the last add(). Drops events whose order differs between the
  /// sides.
  void finish();
  std::int64_t to_b(std::int64_t t) const { return map(t, &Pair::first, &Pair::second); }
  std::int64_t to_a(std::int64_t t) const { return map(t, &Pair::second, &Pair::first); }
  /// Returns the tolerance, ns, for events that count as simultaneous at time `t` of side 0 or 1.
  std::int64_t near_ns(std::size_t side, std::int64_t t) const;
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  std::int64_t map(std::int64_t t, std::int64_t Pair::*from, std::int64_t Pair::*to) const;

  std::vector<Pair> pairs_;
};

}  // namespace robosim::analysis
