// Finds a controller that changes the motors too rarely, although the sketch reads its sensors often.
//
//   if (now - last < 100) return;  last = now;  output = kp * error;    // at 0.7 m/s: 70 mm with one command
//
// Some PID libraries compute only every 100 ms unless the sketch sets another time. The sketch does read its
// sensors in each pass of loop(), so that it does not drive blindly (blind_driving.h). But between two
// computations, the readings have no effect. A finding is a loss of the line with these properties:
//
//   - the motor commands changed at regular times, at least four times in a row. Each interval is a multiple
//     of the shortest one, within 5 % or 2 ms. The shortest interval is 20 ms or longer;
//   - in each interval, the sketch read floor sensors in four ticks or more;
//   - a sensor was over the line between two changes that are 20 mm or more apart, and no sensor was over the
//     line at the second change. The robot did not find the line again, or lost it three times in this way.
//
// To fix a finding, compute more often: SetSampleTime(5) in PID libraries. Not detected: irregular intervals.
#pragma once

#include <optional>
#include <vector>

#include "sim/detect/steering_detector.h"

namespace robosim::detect {

class SlowControl final : public SteeringDetector {
 public:
  SlowControl(exec::Executor& executor, SnapshotRegistry& snapshots);

  void look(const Steering& now) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  struct State {
    Steering before;
    Steering changed;         ///< the tick of the last change of the commands
    SimTime shortest = 0;     ///< shortest interval between changes in the present row; 0 = no row
    int regular = 0;          ///< number of regular intervals in the row
    int reads = 0;            ///< ticks with a read since the last change
    bool saw_line = false;    ///< a sensor has been over the line since the last change
    exec::Detected lost;      ///< the first loss of the line; `times` counts all losses
    bool found_again = true;  ///< a sensor has been over the line since the last loss
  };

  void commands_changed(const Steering& now);

  State state_;
};

}  // namespace robosim::detect
