#include "sim/campaign/analysis/alignment.h"

#include <algorithm>
#include <cstdlib>

namespace robosim::analysis {

std::int64_t seen_ns(const History& history) { return history.lost_ns.value_or(history.end_ns); }

std::string seconds(std::int64_t ns) {
  const std::int64_t ms = (ns + 500'000) / 1'000'000;
  std::string text = std::to_string(ms / 1000) + ".";
  const std::string rest = std::to_string(ms % 1000);
  return text + std::string(3 - rest.size(), '0') + rest + " s";
}

void Clocks::finish() {
  pairs_.emplace_back(0, 0);
  std::sort(pairs_.begin(), pairs_.end());
  std::vector<Pair> rising;
  for (const Pair& pair : pairs_)
    if (rising.empty() || (pair.first > rising.back().first && pair.second > rising.back().second))
      rising.push_back(pair);
  pairs_ = std::move(rising);
}

std::int64_t Clocks::map(std::int64_t t, std::int64_t Pair::*from, std::int64_t Pair::*to) const {
  std::size_t i = 0;
  while (i + 1 < pairs_.size() && pairs_[i + 1].*from <= t) ++i;
  const Pair& last = pairs_[i];
  if (i + 1 == pairs_.size()) return last.*to + (t - last.*from);
  const Pair& next = pairs_[i + 1];
  const double share = static_cast<double>(t - last.*from) / static_cast<double>(next.*from - last.*from);
  return last.*to + static_cast<std::int64_t>(share * static_cast<double>(next.*to - last.*to));
}

std::int64_t Clocks::near_ns(std::size_t side, std::int64_t t) const {
  std::int64_t away = t;
  for (const Pair& pair : pairs_) away = std::min(away, std::abs(t - (side == 0 ? pair.first : pair.second)));
  return kNear_ns + away * kApart_percent / 100;
}

}  // namespace robosim::analysis
