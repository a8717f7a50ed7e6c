// Decides whether a target, with its clock a little off, does what another target did.
// docs/howto/comparing.md explains why that separates chance from a fault.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "sim/analysis/compare.h"

namespace robosim::analysis {

/// Time for which a run must follow another one after a difference, to count as equal.
constexpr std::int64_t kBehindEdge_ns = 2'000'000'000;

/// Returns whether `mine` does as `other` where two targets differ, and for `behind_ns` more; or ends in the
/// same way.
bool does_as(const History& mine, const History& other, const Difference& found,
             std::int64_t behind_ns = kBehindEdge_ns);

/// Returns whether a target's own difference resembles the one found, within 2 s of it. At any time, it may
/// also be between the same two behaviours. These are the same two manoeuvres, or the same two times at
/// places of one kind.
bool is_alike(const Difference& own, const Difference& found);

/// A condition that a run may meet or not.
struct ComesTo {
  std::string place;
  std::size_t times = 1;   ///< number of occurrences …
  std::int64_t by_ns = 0;  ///< … by then
};
struct Moves {
  Manoeuvre manoeuvre = Manoeuvre::stands;
  std::int64_t from_ns = 0, to_ns = 0;
};
struct EndsAs {
  std::string verdict;
};

/// A difference reduced to a question that each run of either target answers.
class Choice {
 public:
  /// Returns nothing if there is none: a mean speed.
  static std::optional<Choice> of(const Difference& found, const History& first, const History& second);
  /// Returns whether a run behaves like the first one, where `first` and `second` part.
  bool is_as_first(const History& run) const;

 private:
  bool holds_for(const History& run) const;
  static std::optional<std::int64_t> time_at(const ComesTo& comes, const History& run);

  std::variant<ComesTo, Moves, EndsAs> what_;
  bool of_first_ = true;  ///< true for the first; else for the second only
};

/// The number of runs of a target, with clocks a little off, and how many of them behave like the first one.
struct Share {
  int runs = 0, as_first = 0;
};
enum class Alikeness {
  alike,  ///< both targets show both, equally often; or one shows its own with only one clock of a hundred
  apart,  ///< one shows a behaviour that the other never or seldom shows
  rare,   ///< too few runs: one of the two behaviours is rare
};
/// Uses Fisher's exact test, which reports equal targets as different in at most 1 of 20 pairs.
Alikeness alikeness(const Share& one, const Share& other);

/// Returns whether it is about the robot's place or time: not about its output, and without a known cause.
bool is_of_driving(const Difference& difference);

}  // namespace robosim::analysis
