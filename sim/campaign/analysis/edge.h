// Decides whether a difference between two targets is chance: whether one target, with a slightly wrong
// clock, behaves like the other. docs/howto/comparing.md explains the method.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "sim/campaign/analysis/compare.h"

namespace robosim::analysis {

/// Two runs count as equal if they agree for this time after the difference.
constexpr std::int64_t kBehindEdge_ns = 2'000'000'000;

/// Returns whether `mine` equals `other` until `behind_ns` after the difference `found`. If a run ends
/// earlier, both must end in the same way, at about the same time.
bool does_as(const History& mine, const History& other, const Difference& found,
             std::int64_t behind_ns = kBehindEdge_ns);

/// Returns whether `own`, a difference between two runs of one target, resembles `found`, a difference
/// between targets. Differences within 2 s of each other only need to be of the same kind. Here, place and
/// time count as one kind, and so do motors and speed. Differences at other times must separate the same two
/// behaviours: two manoeuvres, or two arrival times at a place. (Numbers in the place's name may differ.)
bool is_alike(const Difference& own, const Difference& found);

/// A condition on a run: the robot comes to a place by a certain time.
struct ComesTo {
  std::string place;
  std::size_t times = 1;   ///< number of visits …
  std::int64_t by_ns = 0;  ///< … by this time
};
struct Moves {
  Manoeuvre manoeuvre = Manoeuvre::stands;
  std::int64_t from_ns = 0, to_ns = 0;
};
struct EndsAs {
  std::string verdict;
};

/// A condition on a run that distinguishes the two sides of a difference.
class Choice {
 public:
  /// Derives the condition from `found`. Returns nullopt for a difference without such a condition, such as a
  /// difference in mean speed.
  static std::optional<Choice> of(const Difference& found, const History& first, const History& second);
  /// Returns whether a run behaves like `first` at the difference.
  bool is_as_first(const History& run) const;

 private:
  bool holds_for(const History& run) const;
  static std::optional<std::int64_t> time_at(const ComesTo& comes, const History& run);

  std::variant<ComesTo, Moves, EndsAs> what_;
  bool of_first_ = true;  ///< true: `first` meets the condition; false: only `second` meets it
};

/// The number of a target's runs with slightly wrong clocks, and for how many Choice::is_as_first() is true.
struct Share {
  int runs = 0, as_first = 0;
};
enum class Alikeness {
  alike,  ///< both targets show both behaviours about equally often, or one behaviour occurs just once
  apart,  ///< one target shows a behaviour that the other never or seldom shows
  rare,   ///< one of the two behaviours is rare, and too few runs were made to decide
};
/// Compares two shares by Fisher's exact test, which reports equal targets as different in at most 1 of 20
/// pairs.
Alikeness alikeness(const Share& one, const Share& other);

/// Returns whether a difference concerns the robot's motion, not its output, and has no known cause.
bool is_of_driving(const Difference& difference);

}  // namespace robosim::analysis
