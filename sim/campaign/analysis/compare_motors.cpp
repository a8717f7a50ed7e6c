#include "sim/campaign/analysis/compare_motors.h"

#include <algorithm>
#include <cmath>

namespace robosim::analysis {
namespace {

// Minimum durations: of a manoeuvre to look for on the other side, and of that manoeuvre on the other side.
constexpr std::int64_t kLong_ns = 500'000'000, kShort_ns = 100'000'000;
constexpr double kSpeed = 0.25;  // a larger difference is reported, as a share of the full command

double mean_command(const History& history, std::int64_t from, std::int64_t to) {
  double sum = 0.0;
  for (const Stretch& s : history.stretches) {
    const std::int64_t overlap = std::min(s.to_ns, to) - std::max(s.from_ns, from);
    if (overlap > 0) sum += static_cast<double>(overlap) * (s.left + s.right) / 2;
  }
  return sum / static_cast<double>(to - from);
}

}  // namespace

std::optional<Difference> missing_manoeuvre(const std::array<const History*, 2>& sides, std::size_t side,
                                            const Clocks& clocks) {
  const std::size_t other = 1 - side;
  const auto map = [&](std::int64_t t) { return side == 0 ? clocks.to_b(t) : clocks.to_a(t); };
  for (const Stretch& stretch : sides[side]->stretches) {
    if (stretch.duration_ns() < kLong_ns) continue;
    const std::int64_t from = map(stretch.from_ns), to = map(stretch.to_ns);
    if (to > seen_ns(*sides[other])) break;
    const std::int64_t near = clocks.near_ns(side, stretch.from_ns);
    std::int64_t found = 0;
    const Stretch* there = nullptr;
    for (const Stretch& s : sides[other]->stretches) {
      if (s.from_ns <= from && s.to_ns > from) there = &s;
      if (s.manoeuvre != stretch.manoeuvre) continue;
      const std::int64_t overlap = std::min(s.to_ns, to + near) - std::max(s.from_ns, from - near);
      found += std::max<std::int64_t>(overlap, 0);
    }
    if (found >= kShort_ns) continue;
    Difference d{Difference::Kind::motors, "the motors", {}, {}, "", {}};
    d.stretch[side] = static_cast<std::size_t>(&stretch - sides[side]->stretches.data());
    d.t_ns[side] = stretch.from_ns;
    d.t_ns[other] = from;
    d.sides[side] = std::string(name_of(stretch.manoeuvre)) + " for " + seconds(stretch.duration_ns());
    d.sides[other] = there ? name_of(there->manoeuvre) : "does not";
    return d;
  }
  return std::nullopt;
}

std::optional<Difference> speed_difference(const std::array<const History*, 2>& sides, const Clocks& clocks) {
  auto pairs = clocks.pairs();
  const std::int64_t rest =
      std::min(seen_ns(*sides[0]) - pairs.back().first, seen_ns(*sides[1]) - pairs.back().second);
  if (rest > 0) pairs.emplace_back(pairs.back().first + rest, pairs.back().second + rest);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const std::array<std::int64_t, 2> from{pairs[i - 1].first, pairs[i - 1].second},
        to{pairs[i].first, pairs[i].second};
    if (std::min(to[0] - from[0], to[1] - from[1]) < kSecond_ns) continue;
    const double a = mean_command(*sides[0], from[0], to[0]), b = mean_command(*sides[1], from[1], to[1]);
    if (std::fabs(a - b) <= kSpeed) continue;
    const auto text = [](double share) {
      return "drives at " + std::to_string(static_cast<int>(std::lround(100.0 * share))) + " % on average";
    };
    return Difference{
        Difference::Kind::speed, "the motors until " + seconds(to[0]), from, {text(a), text(b)}, "", {}};
  }
  return std::nullopt;
}

}  // namespace robosim::analysis
