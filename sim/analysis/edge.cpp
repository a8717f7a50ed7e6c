#include "sim/analysis/edge.h"

#include <algorithm>
#include <cstdlib>

#include "sim/analysis/alignment.h"

namespace robosim::analysis {
namespace {

using Kind = Difference::Kind;

constexpr std::int64_t kBehind_ns = 2'000'000'000;

std::string end_of(const History& history) { return history.lost_ns ? kOffTheLine : history.verdict; }

}  // namespace

bool is_of_driving(const Difference& d) {
  return d.cause.empty() && d.kind != Kind::line && d.kind != Kind::number;
}

bool does_as(const History& mine, const History& other, const Difference& found) {
  const std::int64_t until = found.first_ns() + kBehind_ns;
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
