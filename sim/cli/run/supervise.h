// Runs user code in a separate process, so that a crash or an endless loop is reported in one sentence.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "sim/map/cells/cell_robot.h"

namespace robosim::cli {

/// The child process's progress, in shared memory. The parent can still read this memory after a crash of the
/// child.
class Progressed final : public cells::MoveWatcher {
 public:
  void moved(const cells::CellPose& pose, cells::Sense, cells::Move, double) override {
    pose_ = pose;
    moves_.fetch_add(1, std::memory_order_relaxed);
  }
  std::uint64_t moves() const { return moves_.load(std::memory_order_relaxed); }
  /// Returns the pose before the last move.
  const cells::CellPose& pose() const { return pose_; }
  void finish() { finished_ = true; }
  bool finished() const { return finished_; }

 private:
  std::atomic<std::uint64_t> moves_{0};
  cells::CellPose pose_;
  bool finished_ = false;
};

/// Runs `work` in a child process. `work` receives the shared memory, prints its output and returns the exit
/// status. Returns 1 if the child crashes, exits before `work` returns, or makes no move in 5 s of processor
/// time. In these cases, also writes a sentence to standard error; `name` is its subject.
int supervise(const std::string& name, const std::function<int(Progressed&)>& work);

}  // namespace robosim::cli
