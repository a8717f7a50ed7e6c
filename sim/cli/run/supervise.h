// Runs what a user wrote in a process of its own, so that a crash or an endless loop is told in one sentence.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "sim/cells/cell_robot.h"

namespace robosim::cli {

/// How far the other process has come: shared memory, which survives it.
class Progressed final : public cells::MoveWatcher {
 public:
  void moved(const cells::CellPose& pose, cells::Sense, cells::Move, double) override {
    pose_ = pose;
    moves_.fetch_add(1, std::memory_order_relaxed);
  }
  std::uint64_t moves() const { return moves_.load(std::memory_order_relaxed); }
  /// Before the last move.
  const cells::CellPose& pose() const { return pose_; }
  void finish() { finished_ = true; }
  bool finished() const { return finished_; }

 private:
  std::atomic<std::uint64_t> moves_{0};
  cells::CellPose pose_;
  bool finished_ = false;
};

/// `work` gets the memory, prints what there is to print and gives the exit status. A process that dies, ends
/// by itself, or spends 5 s of processor time without a move gives exit status 1, and a sentence about `name`
/// on the standard error.
int supervise(const std::string& name, const std::function<int(Progressed&)>& work);

}  // namespace robosim::cli
