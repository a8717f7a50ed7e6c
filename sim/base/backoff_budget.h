// Decides whether examining a loop pays off, by comparing savings and costs in firmware cycles. A loop that
// does not pay off is banned: the caller ignores it for a while. Each further ban lasts twice as long.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robosim {

class BackoffBudget {
 public:
  /// Records the cycles that were saved; negative = spent. Returns whether examining the loop still pays off.
  bool pay(std::int64_t cycles, std::uint64_t now) {
    budget_ = std::min(budget_ + cycles, kMost);
    if (budget_ > kLeast) return true;
    banned_until_ = now + (kFirstBan << bans_);
    bans_ = std::min(bans_ + 1, kMostBans);
    return false;
  }
  bool is_banned(std::uint64_t now) const { return now < banned_until_; }
  void begin_anew() { budget_ = 0; }
  /// Shortens a present ban after time has jumped back to `now`: it ends no later than a new ban would.
  void moved_in_time(std::uint64_t now) {
    banned_until_ = std::min(banned_until_, now + (kFirstBan << bans_));
  }

 private:
  static constexpr std::int64_t kMost = 1'000'000, kLeast = -20'000;
  static constexpr std::uint64_t kFirstBan = 4'000'000;
  static constexpr int kMostBans = 20;

  std::int64_t budget_ = 0;
  std::uint64_t banned_until_ = 0;
  int bans_ = 0;
};

}  // namespace robosim
