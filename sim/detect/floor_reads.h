// Reports when the firmware last read a floor sensor, for the detectors that examine how a robot steers.
#pragma once

#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class FloorReads {
 public:
  FloorReads(const robot::Robot& robot, exec::Executor& executor);

  /// Returns whether reads can be observed. For this, the robot must have floor sensors, and each sensor must
  /// be wired to a pin of the board.
  bool are_known() const { return !pins_.empty(); }
  /// Returns the time of the firmware's last read of a floor sensor; -1 if the firmware has read no sensor.
  /// If an interrupt waits for a sensor's edges, the sensor counts as read at `now`. This rule excludes pins
  /// whose edges a timer can capture.
  SimTime last(SimTime now) const;

 private:
  exec::Executor& executor_;
  std::vector<Pin> pins_;
};

}  // namespace robosim::detect
