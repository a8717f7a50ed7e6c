#include "sim/analysis/edge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/analysis/alignment.h"
#include "sim/analysis/line_text.h"

namespace robosim::analysis {
namespace {

using Kind = Difference::Kind;

constexpr std::int64_t kBehind_ns = 2'000'000'000, kAboutThen_ns = 2'000'000'000;

/// "comes 2.220 s after the one before" and "comes 2.180 s after the one before"
bool is_same_way(const std::string& one, const std::string& other, const Tolerance& tolerance) {
  const LineText a = take_apart(one), b = take_apart(other);
  if (a.form != b.form) return false;
  if (a.form.find(" after ") == std::string::npos) return true;  // numbers are names of places, or durations
  const double x = a.numbers[0].value, y = b.numbers[0].value;
  return std::fabs(x - y) <= 1e-9 * static_cast<double>(tolerance.time_ns) + tolerance.time * std::fmax(x, y);
}

/// Another place, and the same one much later, are one sort; so are another manoeuvre and another speed.
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
