// Compares the behaviour of two targets: two histories, aligned by events rather than by the clock.
// Instructions take different times on each target. The same robot therefore turns at a slightly different
// time and place.
//
// docs/howto/comparing.md defines the differences; in short:
//
//   places    their names and order
//   lines     their text and order, without numbers; a text that occurs more than 20 times, or 5 times in
//             2 s, is a stream: both sides must send it at about the same rate and at about the same time
//   numbers   in a line: within 10 % of each other
//             in a stream: within 10 % of a value that the other side prints at most 1 s before or after, or
//             within the range of these values. The range is widened at both ends by half its width, and
//             by at least 1 if all values of the stream span 10 or more
//   times     from one place or line to the next: within 0.5 s plus 25 %
//   motors    for a manoeuvre of 0.5 s or more, the other side makes the same manoeuvre for 0.1 s or more,
//             within 1 s plus 1 % of the time to the nearest common place or line;
//             the mean commands between two common places or lines differ by at most 0.25 of full speed
//   the end   equal verdicts
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/analysis/history.h"

namespace robosim::analysis {

struct Tolerance {
  double time = 0.25;                  ///< relative tolerance of a time …
  std::int64_t time_ns = 500'000'000;  ///< … plus this absolute tolerance
  double number = 0.10;                ///< share of the larger number

  /// Returns the tolerance for a duration.
  std::int64_t time_for(std::int64_t duration_ns) const {
    return time_ns + static_cast<std::int64_t>(time * static_cast<double>(duration_ns));
  }
};

struct Difference {
  enum class Kind { place, line, number, time, motors, speed, verdict };
  Kind kind = Kind::verdict;
  std::string what;                                     ///< "line 3", "the way after junction 2"
  std::array<std::int64_t, 2> t_ns{};                   ///< time of the difference on each side
  std::array<std::string, 2> sides;                     ///< behaviour of each side: "\"sum 40000\""
  std::string cause;                                    ///< "integer width: …"; empty if unknown
  std::array<std::optional<std::size_t>, 2> line;       ///< index in History::lines, if a line differs
  std::array<std::optional<std::size_t>, 2> place{};    ///< index in History::places, if a place differs
  std::array<std::optional<std::size_t>, 2> stretch{};  ///< index in History::stretches, if a stretch differs

  /// Returns the earlier of the two times, because a consequence of the difference may appear before the
  /// later time.
  std::int64_t first_ns() const { return std::min(t_ns[0], t_ns[1]); }
};

/// A harmless difference of a known kind: the same value, printed differently.
struct KnownDifference {
  std::string what;
  std::array<std::string, 2> sides;
  bool operator==(const KnownDifference&) const = default;
};

struct Comparison {
  std::optional<Difference> first;  ///< earliest by first_ns(); nullopt if both behave equally
  std::vector<KnownDifference> known;
};

Comparison compare(const History& a, const History& b, const Tolerance& tolerance = {});

/// Returns "place", "line" …
const char* name_of(Difference::Kind kind);

}  // namespace robosim::analysis
