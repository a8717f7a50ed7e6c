// Finds a sketch that stops steering without stopping its motors. The motors then keep their last commands.
//
//   if (millis() - seen_at > 300) { running = false; Serial.println("lost"); }  // and the robot drives on
//
// The fault shows only when the robot loses its line. For example, someone touches a wheel, or the floor is
// dirty. In a finding, the wheels have turned a metre since a sensor last saw the line (verdict `lost`). For
// at least the last half metre, the motors ran with unchanged commands, and no floor sensor was read. The
// sketch must not be waiting in a call, because BlindDriving reports such waits. To fix a finding, stop or
// brake the motors wherever the sketch stops steering.
//
// Not detected: sensors on a shift register; sensors that are read by interrupt handlers; a robot that
// meets a line by chance.
#pragma once

#include <vector>

#include "sim/detect/steering_detector.h"

namespace robosim::detect {

class MotorsLeftOn final : public SteeringDetector {
 public:
  MotorsLeftOn(exec::Executor& executor, SnapshotRegistry& snapshots) : executor_(executor) {
    snapshots.add(state_);
  }

  void look(const Steering& now) override;
  std::vector<exec::Detected> found(SimTime) const override { return state_.found; }

 private:
  /// The drive since a sensor last saw the line.
  struct Stretch {
    bool counts = false;  ///< a sensor saw the line, no manual move followed, and nothing was reported yet
    SimTime began = 0;
    double from_m = 0.0;
    double unchanged_from_m = 0.0;  ///< travel when a command last changed, or a sensor was last read
    double left = 0.0, right = 0.0;
  };

  void tell(double on_m);

  struct State {
    int reads = 0;  ///< ticks with a read of a floor sensor
    Stretch stretch;
    std::vector<exec::Detected> found;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
