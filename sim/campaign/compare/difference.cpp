#include "sim/campaign/compare/difference.h"

#include <algorithm>

namespace robosim::campaign {
namespace {

constexpr std::int64_t kUntilItShows_ns = 5'000'000'000;

}  // namespace

bool lacks_something(const ComparedTarget& target_run) {
  return std::any_of(target_run.robots.begin(), target_run.robots.end(),
                     [](const auto& robot) { return !robot.result.lacks.empty(); });
}

void find_lacks(Compared& compared, std::size_t robot, const std::array<std::size_t, 2>& target_runs) {
  compared.lacks.clear();
  const bool is_explained = !compared.difference->cause.empty() || compared.sides[0].finding.has_value() ||
                            compared.sides[1].finding.has_value();
  if (is_explained) return;
  for (std::size_t side = 0; side < 2 && compared.lacks.empty(); ++side) {
    const ComparedTarget& target_run = compared.target_runs[target_runs[side]];
    const double until_s = 1e-9 * static_cast<double>(compared.difference->t_ns[side]);
    compared.lacking = target_run.target;
    for (const result::Lack& lack : target_run.robots[robot].result.lacks)
      if (lack.first_s <= until_s) compared.lacks.push_back(lack);
  }
}

std::size_t first_difference(const Compared& compared, std::size_t side, const std::string& text) {
  const std::string& own = compared.difference->sides[side];
  const std::string& other = compared.difference->sides[1 - side];
  const std::size_t begin = own.find('"');
  if (begin == own.npos) return 0;
  const auto apart = std::mismatch(own.begin(), own.end(), other.begin(), other.end());
  const auto at = static_cast<std::size_t>(apart.first - own.begin());
  return at > begin ? std::min(at - begin - 1, text.size()) : 0;
}

std::int64_t shows_by(const Compared& compared) {
  const analysis::Difference& d = *compared.difference;
  const std::int64_t later = std::max(d.t_ns[0], d.t_ns[1]);
  const bool waits = d.place[0].has_value() != d.place[1].has_value();
  const analysis::Tolerance tolerance;
  return later + kUntilItShows_ns +
         (waits ? static_cast<std::int64_t>(tolerance.time * static_cast<double>(later)) : 0);
}

}  // namespace robosim::campaign
