#include "sim/analysis/edge.h"

#include <cmath>
#include <cstdlib>

#include "sim/analysis/line_text.h"

namespace robosim::analysis {
namespace {

using Kind = Difference::Kind;

constexpr std::int64_t kAboutThen_ns = 2'000'000'000;

/// Another place, and the same one much later, are one sort; so are another manoeuvre and another speed.
Kind sort_of(const Difference& d) {
  if (d.kind == Kind::time) return Kind::place;
  return d.kind == Kind::speed ? Kind::motors : d.kind;
}

std::string word_of(const std::string& verdict) { return verdict.substr(0, verdict.find(':')); }

/// "comes 2.220 s after the one before" and "comes 2.180 s after the one before"
bool is_same_way(const std::string& one, const std::string& other, const Tolerance& tolerance) {
  const LineText a = take_apart(one), b = take_apart(other);
  if (a.form != b.form) return false;
  if (a.form.find(" after ") == std::string::npos) return true;  // numbers are names of places, or durations
  const double x = a.numbers[0].value, y = b.numbers[0].value;
  return std::fabs(x - y) <= 1e-9 * static_cast<double>(tolerance.time_ns) + tolerance.time * std::fmax(x, y);
}

bool are_same_ways(const Difference& own, const Difference& found) {
  const Tolerance tolerance;
  const auto match = [&](std::size_t first) {
    return is_same_way(own.sides[0], found.sides[first], tolerance) &&
           is_same_way(own.sides[1], found.sides[1 - first], tolerance);
  };
  return take_apart(own.what).form == take_apart(found.what).form && (match(0) || match(1));
}

}  // namespace

bool is_of_driving(const Difference& d) {
  return d.cause.empty() && d.kind != Kind::line && d.kind != Kind::number;
}

Alike alike(const Difference& own, const Difference& found) {
  if (sort_of(own) != sort_of(found) || !is_of_driving(own)) return Alike::no;
  if (own.kind == Kind::verdict) {
    const std::string then = word_of(own.sides[1]);
    const bool is =
        word_of(own.sides[0]) != then && (then == word_of(found.sides[0]) || then == word_of(found.sides[1]));
    return is ? Alike::there : Alike::no;
  }
  if (std::abs(own.first_ns() - found.first_ns()) <= kAboutThen_ns) return Alike::there;
  return own.kind == found.kind && own.kind != Kind::speed && are_same_ways(own, found) ? Alike::elsewhere
                                                                                        : Alike::no;
}

}  // namespace robosim::analysis
