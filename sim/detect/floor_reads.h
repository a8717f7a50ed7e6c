// Provides the firmware's reads of floor sensors to the detectors that examine how a robot steers.
#pragma once

#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class FloorReads {
 public:
  FloorReads(const robot::Robot& robot, exec::Executor& executor);

  /// Returns whether reads are visible: the robot has floor sensors, and each is wired to a pin of the board.
  bool are_known() const { return !pins_.empty(); }
  /// Returns the time of the firmware's last read of a floor sensor; -1 = never. Returns `now` if an
  /// interrupt waits for a sensor's edges.
  SimTime last(SimTime now) const;

 private:
  exec::Executor& executor_;
  std::vector<Pin> pins_;
};

}  // namespace robosim::detect
