// Robots on the edge: whether a target, with its clock a little off, does what another did in its place.
// docs/howto/comparing.md says why that tells chance from a fault.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "sim/analysis/compare.h"

namespace robosim::analysis {

/// How long a run must do as another did behind a difference, to be taken for the same.
constexpr std::int64_t kBehindEdge_ns = 2'000'000'000;

/// Whether `mine` does as `other` did where two targets differ, and for `behind_ns` more; or ends as that
/// does.
bool does_as(const History& mine, const History& other, const Difference& found,
             std::int64_t behind_ns = kBehindEdge_ns);

/// Whether a target's own difference is of the sort of that found, within 2 s of it; or, wherever, between
/// the same two ways: the same two manoeuvres, the same two times at places of one sort.
bool is_alike(const Difference& own, const Difference& found);

/// What a run may do, or not.
struct ComesTo {
  std::string place;
  std::size_t times = 1;   ///< so many times it has come there …
  std::int64_t by_ns = 0;  ///< … by then
};
struct Moves {
  Manoeuvre manoeuvre = Manoeuvre::stands;
  std::int64_t from_ns = 0, to_ns = 0;
};
struct EndsAs {
  std::string verdict;
};

/// What a difference comes down to: a question that each run answers, of either target.
class Choice {
 public:
  /// Nothing where there is none: a mean speed.
  static std::optional<Choice> of(const Difference& found, const History& first, const History& second);
  /// Whether a run goes the first one's way, in the place where `first` and `second` part.
  bool is_as_first(const History& run) const;

 private:
  bool holds_for(const History& run) const;
  static std::optional<std::int64_t> time_at(const ComesTo& comes, const History& run);

  std::variant<ComesTo, Moves, EndsAs> what_;
  bool of_first_ = true;  ///< what holds for the first; else for the second only
};

/// Of so many runs of a target, with clocks a little off, so many go the first one's way.
struct Share {
  int runs = 0, as_first = 0;
};
enum class Alikeness {
  alike,  ///< both targets go both ways, about as often; or one goes its way with one clock of a hundred only
  apart,  ///< one goes a way that the other never goes, or seldom
  rare,   ///< of too few runs to say: one of the two ways is seldom gone
};
/// By Fisher's exact test, which finds targets that are alike apart in 1 of 20 pairs at most.
Alikeness alikeness(const Share& one, const Share& other);

/// It is where the robot is, and when: not what it says, and it has no cause that has a name.
bool is_of_driving(const Difference& difference);

}  // namespace robosim::analysis
