// The times of two histories side by side.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/analysis/history.h"

namespace robosim::analysis {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kNear_ns = kSecond_ns;  ///< what is no further apart happens at about one time
/// Two boards of one kind, of which one is 0.5 % fast and the other as slow (an Uno's resonator, Murata
/// CSTCE16M0V53), are so much of the time further apart that has passed since an event that both have.
constexpr std::int64_t kApart_percent = 1;

/// Until when what the robot does counts: until it has lost the line, else to the end.
std::int64_t seen_ns(const History& history);

/// "1.234 s".
std::string seconds(std::int64_t ns);

/// From one side's time to the other's: by events that both have, and evenly between them.
class Clocks {
 public:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  /// The times, in ns, of an event that both sides have; the starts are one.
  void add(std::int64_t a, std::int64_t b) { pairs_.emplace_back(a, b); }
  /// Once all events are added, before the first question. Those that came in another order are left out.
  void finish();
  std::int64_t to_b(std::int64_t t) const { return map(t, &Pair::first, &Pair::second); }
  std::int64_t to_a(std::int64_t t) const { return map(t, &Pair::second, &Pair::first); }
  /// How far apart what happens at about one time may be, at `t` of the first side (0) or the second (1).
  std::int64_t near_ns(std::size_t side, std::int64_t t) const;
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  std::int64_t map(std::int64_t t, std::int64_t Pair::*from, std::int64_t Pair::*to) const;

  std::vector<Pair> pairs_;
};

}  // namespace robosim::analysis
