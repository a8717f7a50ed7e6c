// Finds a robot that reads its line only as often as Serial permits. At 9600 baud a byte takes 1 ms, and a
// print waits for what does not fit into Serial's buffer of 64 bytes. A line of 40 bytes in each step makes
// steps of 40 ms, whatever the sketch assumes.
//
//   Serial.print("error "); Serial.print(error); …          // in each round of loop(), or each step
//
// It may well keep its line, as its rounds are regular. But the derivative differs, and so do all times that
// are counted in rounds. Without Serial, or on a narrower line, it drives like another robot.
//
// A finding is a sketch that spends 30 % of its driving time in stretches of at least 15 ms without reading a
// floor sensor. There must be ten of them or more, in each of which a call of Serial was waiting. So a sketch
// that occasionally prints much, or drives without a line, is not reported. To fix it, print fewer bytes,
// print less often (if (millis() - told_at > 500)), or use a faster Serial.begin().
#pragma once

#include <vector>

#include "sim/judge/floor_looks.h"

namespace robosim::judge {

class SlowSerial {
 public:
  explicit SlowSerial(exec::Executor& executor) : executor_(&executor) {}

  void look(const Steering& now);
  /// Returns the findings at the end of the run.
  std::vector<exec::Detected> found() const;

 private:
  void end(const Steering& now);

  exec::Executor* executor_;
  SimTime began_ = 0;  ///< tick of the last read of a floor sensor
  double from_m_ = 0.0;
  bool waits_ = false;               ///< a call of Serial has waited in this stretch
  SimTime driven_ = 0, waited_ = 0;  ///< of all stretches
  int asked_ = 0, times_ = 0;
  double longest_s_ = 0.0, furthest_m_ = 0.0;
  exec::Activity first_;
  SimTime first_at_ = 0;
};

}  // namespace robosim::judge
