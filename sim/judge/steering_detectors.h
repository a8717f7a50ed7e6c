// The detectors that examine how a robot steers along its line.
#pragma once

#include <vector>

#include "sim/judge/blind_driving.h"
#include "sim/judge/motors_left_on.h"
#include "sim/judge/slow_serial.h"

namespace robosim::judge {

class SteeringDetectors {
 public:
  /// `lever_m` is the distance of the robot's sensors ahead of its axle; `line_m` is the width of the line.
  SteeringDetectors(const robot::Robot& robot, exec::Executor& executor, double lever_m, double line_m)
      : floor_(robot, executor),
        blind_driving_(executor, lever_m, line_m),
        left_on_(executor),
        serial_(executor) {}

  /// Examines a tick. Does nothing if reads of the floor are not visible.
  void look(Steering now) {
    if (!floor_.are_known()) return;
    now.asks_floor = floor_.last(now.t) >= before_;
    before_ = now.t;
    blind_driving_.look(now);
    left_on_.look(now);
    serial_.look(now);
  }
  /// Returns the findings at the end of the run.
  std::vector<exec::Detected> found() const {
    std::vector<exec::Detected> all = blind_driving_.found();
    for (const auto& some : {left_on_.found(), serial_.found()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }

 private:
  FloorLooks floor_;
  SimTime before_ = 0;  ///< time of the previous tick
  BlindDriving blind_driving_;
  MotorsLeftOn left_on_;
  SlowSerial serial_;
};

}  // namespace robosim::judge
