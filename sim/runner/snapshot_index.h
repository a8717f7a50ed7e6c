// Stores snapshots of a run at intervals, so that a snapshot exists shortly before each time of the run.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/run/simulation.h"

namespace robosim::runner {

struct IndexedSnapshot {
  SimTime t = 0;
  run::Simulation::Snapshot snapshot;
  std::uint64_t told = 0;  ///< number of the run's reports before the snapshot
};

class SnapshotIndex {
 public:
  static constexpr SimTime kEvery = 100 * kMillisecond;

  /// Returns the time at which the next snapshot is due.
  SimTime next() const { return all_.empty() ? 0 : all_.back().t + every_; }
  /// Adds a snapshot after all others. If there are too many, drops every other one.
  void add(IndexedSnapshot moment) {
    all_.push_back(std::move(moment));
    if (all_.size() < kMost) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all_.size(); i += 2) all_[kept++] = std::move(all_[i]);
    all_.resize(kept);
    every_ *= 2;
  }
  /// Inserts snapshots after snapshot number `behind`.
  void insert(std::size_t behind, const std::vector<IndexedSnapshot>& moments) {
    all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(behind) + 1, moments.begin(), moments.end());
  }
  void clear() { all_.clear(); }

  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  const IndexedSnapshot& operator[](std::size_t i) const { return all_[i]; }
  /// Returns the number of the last snapshot at or before `t`. If all snapshots are later, returns 0.
  std::size_t before(SimTime t) const {
    const auto behind = std::upper_bound(
        all_.begin(), all_.end(), t, [](SimTime at, const IndexedSnapshot& moment) { return at < moment.t; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, behind - all_.begin()) - 1);
  }

 private:
  static constexpr std::size_t kMost = 2048;

  std::vector<IndexedSnapshot> all_;
  SimTime every_ = kEvery;  ///< time between two snapshots
};

}  // namespace robosim::runner
