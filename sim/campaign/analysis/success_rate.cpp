#include "sim/campaign/analysis/success_rate.h"

#include <cmath>

namespace robosim::analysis {
namespace {

constexpr double kZ = 1.959963984540054;  // 97.5 % quantile of the normal distribution

bool meets(const Demand& demand, std::int64_t successes, std::int64_t runs) {
  if (demand.sure) return wilson(successes, runs).low >= demand.rate;
  return static_cast<double>(successes) / static_cast<double>(runs) >= demand.rate;
}

/// Returns the smallest number from `low` to `high` for which `holds` is true. `holds` must be true for
/// `high`, and monotonic.
template <typename Holds>
std::int64_t least(std::int64_t low, std::int64_t high, const Holds& holds) {
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return high;
}

}  // namespace

Interval wilson(std::int64_t successes, std::int64_t runs) {
  if (runs == 0) return {};
  const auto n = static_cast<double>(runs);
  const double p = static_cast<double>(successes) / n;
  const double square = kZ * kZ / n;
  const double centre = p + square / 2;
  const double reach = std::sqrt(square * (p * (1 - p) + square / 4));
  const double low = successes == 0 ? 0.0 : (centre - reach) / (1 + square);
  const double high = successes == runs ? 1.0 : (centre + reach) / (1 + square);
  return {low, high};
}

std::optional<std::int64_t> needed_successes(const Demand& demand, std::int64_t runs) {
  if (!meets(demand, runs, runs)) return std::nullopt;
  return least(0, runs, [&](std::int64_t k) { return meets(demand, k, runs); });
}

std::optional<std::int64_t> needed_runs(const Demand& demand) {
  constexpr std::int64_t kMost = std::int64_t{1} << 50;
  if (!meets(demand, kMost, kMost)) return std::nullopt;
  return least(1, kMost, [&](std::int64_t n) { return meets(demand, n, n); });
}

Tally::Tally(std::int64_t planned, std::optional<Demand> demand)
    : planned_(planned), demanding_(demand.has_value()), needed_(planned + 1) {
  if (demand) needed_ = needed_successes(*demand, planned).value_or(planned + 1);
}

void Tally::add(bool success) {
  ++runs_;
  if (success) ++successes_;
}

double Tally::rate() const {
  return runs_ == 0 ? 0.0 : static_cast<double>(successes_) / static_cast<double>(runs_);
}

bool Tally::met() const { return demanding_ && successes_ >= needed_; }
bool Tally::missed() const { return demanding_ && planned_ - (runs_ - successes_) < needed_; }

}  // namespace robosim::analysis
