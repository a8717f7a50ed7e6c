#include "sim/campaign/analysis/edge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/campaign/analysis/alignment.h"
#include "sim/campaign/analysis/line_text.h"

namespace robosim::analysis {
namespace {

using Kind = Difference::Kind;

constexpr std::int64_t kShortest_ns = 100'000'000;  // shortest manoeuvre
// Each run on a target shows one of two behaviours. Two targets count as alike only if both behaviours occur
// on each target, in at least kFewest runs. If each target has kManyRuns runs or more, one run of each
// behaviour is enough.
constexpr int kFewest = 2, kManyRuns = 100;
constexpr std::int64_t kAboutThen_ns = 2'000'000'000;

/// Returns whether two texts agree, with a tolerance for times. Example: "comes 2.220 s after the previous
/// one" and "comes 2.180 s after the previous one".
bool is_same_way(const std::string& one, const std::string& other, const Tolerance& tolerance) {
  const LineText a = take_apart(one), b = take_apart(other);
  if (a.form != b.form) return false;
  if (a.form.find(" after ") == std::string::npos) return true;  // the numbers are not times
  const double x = a.numbers[0].value, y = b.numbers[0].value;
  return std::fabs(x - y) <= 1e-9 * static_cast<double>(tolerance.time_ns) + tolerance.time * std::fmax(x, y);
}

/// Returns the kind of a difference, with `time` counted as `place`, and `speed` counted as `motors`.
Kind sort_of(const Difference& d) {
  if (d.kind == Kind::time) return Kind::place;
  return d.kind == Kind::speed ? Kind::motors : d.kind;
}

std::string end_of(const History& history) { return history.lost_ns ? kOffTheLine : history.verdict; }

}  // namespace

bool is_of_driving(const Difference& d) {
  return d.cause.empty() && d.kind != Kind::line && d.kind != Kind::number;
}

bool is_alike(const Difference& own, const Difference& found) {
  if (!is_of_driving(own)) return false;
  if (sort_of(own) == sort_of(found) && std::abs(own.first_ns() - found.first_ns()) <= kAboutThen_ns)
    return true;
  if (own.kind != found.kind || own.kind == Kind::speed || own.kind == Kind::verdict) return false;
  const Tolerance tolerance;
  const auto match = [&](std::size_t first) {
    return is_same_way(own.sides[0], found.sides[first], tolerance) &&
           is_same_way(own.sides[1], found.sides[1 - first], tolerance);
  };
  return take_apart(own.what).form == take_apart(found.what).form && (match(0) || match(1));
}

std::optional<std::int64_t> Choice::time_at(const ComesTo& comes, const History& run) {
  std::size_t times = 0;
  for (const TimedText& place : run.places)
    if (place.text == comes.place && ++times == comes.times) return place.t_ns;
  return std::nullopt;
}

bool Choice::holds_for(const History& run) const {
  if (const auto* comes = std::get_if<ComesTo>(&what_)) {
    const auto at = time_at(*comes, run);
    return at && *at <= comes->by_ns;
  }
  if (const auto* ends = std::get_if<EndsAs>(&what_)) return end_of(run) == ends->verdict;
  const Moves& moves = std::get<Moves>(what_);
  std::int64_t moved = 0;
  for (const Stretch& s : run.stretches)
    if (s.manoeuvre == moves.manoeuvre)
      moved += std::max<std::int64_t>(std::min(s.to_ns, moves.to_ns) - std::max(s.from_ns, moves.from_ns), 0);
  return moved >= kShortest_ns;
}

bool Choice::is_as_first(const History& run) const { return holds_for(run) == of_first_; }

std::optional<Choice> Choice::of(const Difference& found, const History& first, const History& second) {
  const std::array<const History*, 2> sides{&first, &second};
  Choice choice;
  if (found.kind == Kind::place || found.kind == Kind::time) {
    const std::size_t side = found.place[0] ? 0 : 1;
    if (!found.place[side]) return std::nullopt;
    const std::size_t number = *found.place[side];
    ComesTo comes{sides[side]->places[number].text, 0, 0};
    for (std::size_t i = 0; i <= number; ++i)
      comes.times += sides[side]->places[i].text == comes.place ? 1 : 0;
    const std::array<std::optional<std::int64_t>, 2> at{time_at(comes, first), time_at(comes, second)};
    const std::size_t sooner = !at[0] || (at[1] && *at[1] < *at[0]) ? 1 : 0;
    const Tolerance tolerance;
    const auto late = static_cast<std::int64_t>(tolerance.time * static_cast<double>(*at[sooner]));
    comes.by_ns = at[1 - sooner] ? (*at[0] + *at[1]) / 2 : *at[sooner] + tolerance.time_ns + late;
    choice.what_ = std::move(comes);
    choice.of_first_ = sooner == 0;
  } else if (found.kind == Kind::motors) {
    const std::size_t side = found.stretch[0] ? 0 : 1;
    const Stretch& stretch = sides[side]->stretches[*found.stretch[side]];
    const std::int64_t near = kNear_ns + kApart_percent * stretch.from_ns / 100;
    choice.what_ = Moves{stretch.manoeuvre, stretch.from_ns - near, stretch.to_ns + near};
    choice.of_first_ = side == 0;
  } else if (found.kind == Kind::verdict) {
    choice.what_ = EndsAs{end_of(first)};
  } else {
    return std::nullopt;
  }
  if (!choice.is_as_first(first) || choice.is_as_first(second)) return std::nullopt;
  return choice;
}

// Applies Fisher's test: adds the probabilities of all tables with equal totals that are not more likely than
// this table. If either target has fewer than kManyRuns runs, a behaviour that one target shows less than
// twice counts as rare.
Alikeness alikeness(const Share& one, const Share& other) {
  constexpr double kUnlikely = 0.05, kRounding = 1e-9;
  const int both = one.as_first + other.as_first;
  const auto log_choose = [](int n, int k) {
    return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
  };
  const auto likelihood = [&](int of_one) {
    return std::exp(log_choose(one.runs, of_one) + log_choose(other.runs, both - of_one) -
                    log_choose(one.runs + other.runs, both));
  };
  double p = 0.0;
  for (int n = std::max(0, both - other.runs); n <= std::min(one.runs, both); ++n)
    if (likelihood(n) <= likelihood(one.as_first) * (1.0 + kRounding)) p += likelihood(n);
  if (p < kUnlikely) return Alikeness::apart;
  const bool many = std::min(one.runs, other.runs) >= kManyRuns;
  if (many && std::min(both, one.runs + other.runs - both) == 1) return Alikeness::alike;
  const auto seldom = [](const Share& share) {
    return std::min(share.as_first, share.runs - share.as_first);
  };
  if (std::min(seldom(one), seldom(other)) >= (many ? 1 : kFewest)) return Alikeness::alike;
  return many ? Alikeness::apart : Alikeness::rare;
}

bool does_as(const History& mine, const History& other, const Difference& found, std::int64_t behind_ns) {
  const std::int64_t until = found.first_ns() + behind_ns;
  const Comparison comparison = compare(mine, other);
  if (comparison.first && comparison.first->first_ns() <= until) return false;
  const std::int64_t a = seen_ns(mine), b = seen_ns(other);
  if (std::min(a, b) >= until) return true;
  const Tolerance tolerance;
  const double allowed =
      static_cast<double>(tolerance.time_ns) + tolerance.time * static_cast<double>(std::max(a, b));
  return end_of(mine) == end_of(other) && static_cast<double>(std::abs(a - b)) <= allowed;
}

}  // namespace robosim::analysis
