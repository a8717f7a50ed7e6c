// Finds a sketch that stops steering but not its motors, which keep their last commands.
//
//   if (millis() - seen_at > 300) { running = false; Serial.println("lost"); }      // and the robot drives
//                                                                                   on
//
// It shows on the day that the robot loses its line: someone touches a wheel, the floor is dirty. A finding
// is a robot whose wheels have turned a metre without a line, as in the verdict `lost`. For at least the last
// half of it, its motor commands were the same and no floor sensor was read. Nor was the sketch waiting in a
// call (BlindDriving covers that). To fix it, stop or brake the motors wherever steering ends.
//
// Not detected: sensors on a shift register, or read by interrupts; a robot that meets a line by luck.
#pragma once

#include <vector>

#include "sim/judge/floor_looks.h"

namespace robosim::judge {

class MotorsLeftOn {
 public:
  explicit MotorsLeftOn(exec::Executor& executor) : executor_(&executor) {}

  void look(const Steering& now);
  /// Returns the findings at the end of the run.
  const std::vector<exec::Detected>& found() const { return found_; }

 private:
  /// The drive since the last time that the line was seen.
  struct Stretch {
    bool counts = false;  ///< it was seen, no manual move followed, and it is not reported yet
    SimTime began = 0;
    double from_m = 0.0;
    double unchanged_from_m = 0.0;  ///< since when commands are unchanged and no sensor is read
    double left = 0.0, right = 0.0;
  };

  void tell(double on_m);

  exec::Executor* executor_;
  int looks_ = 0;
  Stretch stretch_;
  std::vector<exec::Detected> found_;
};

}  // namespace robosim::judge
