// Aligns the times of two histories.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/analysis/history.h"

namespace robosim::analysis {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kNear_ns = kSecond_ns;  ///< events no further apart count as simultaneous
/// Two boards of one kind may be 0.5 % fast and equally slow (an Uno's resonator, Murata CSTCE16M0V53). Their
/// times differ in addition by this share of the time since their last common event.
constexpr std::int64_t kApart_percent = 1;

/// Returns until when the robot's behaviour counts: until it has lost the line, else to the end.
std::int64_t seen_ns(const History& history);

/// Returns "1.234 s".
std::string seconds(std::int64_t ns);

/// Converts one side's time to the other's: by common events, and linearly between them.
class Clocks {
 public:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  /// Adds the times, in ns, of a common event; the starts are one.
  void add(std::int64_t a, std::int64_t b) { pairs_.emplace_back(a, b); }
  /// Call it after the last event, before the first query. Events in another order are dropped.
  void finish();
  std::int64_t to_b(std::int64_t t) const { return map(t, &Pair::first, &Pair::second); }
  std::int64_t to_a(std::int64_t t) const { return map(t, &Pair::second, &Pair::first); }
  /// Returns the tolerance for simultaneous events, at `t` of the first side (0) or the second (1).
  std::int64_t near_ns(std::size_t side, std::int64_t t) const;
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  std::int64_t map(std::int64_t t, std::int64_t Pair::*from, std::int64_t Pair::*to) const;

  std::vector<Pair> pairs_;
};

}  // namespace robosim::analysis
