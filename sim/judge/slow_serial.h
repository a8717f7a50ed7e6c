// A robot that looks at its line as often as Serial lets it. At 9600 baud a byte takes 1 ms, and what does
// not fit into the 64 bytes that Serial keeps is waited for: a line of 40 bytes in each step makes steps of
// 40 ms, whatever the sketch believes them to be.
//
//   Serial.print("error "); Serial.print(error); …          in each round of loop(), or each step
//
// It may well keep its line, as its rounds are even: the derivative is another, and so are all times that are
// counted in rounds; the day Serial is taken out, or the line is narrower, it drives as another robot. Found
// is a sketch that drives, and for 30 % of that time is in stretches of 15 ms and more without a look at a
// floor sensor, ten of them or more, in each of which a call of Serial was waiting. Who prints much at once
// now and then, or drives without a line, is left alone.
//
// Mended by fewer bytes, only now and then (if (millis() - told_at > 500)), or a faster Serial.begin().
#pragma once

#include <vector>

#include "sim/judge/floor_looks.h"

namespace robosim::judge {

class SlowSerial {
 public:
  explicit SlowSerial(exec::Executor& executor) : executor_(&executor) {}

  void look(const Steering& now);
  /// At the end of the run.
  std::vector<exec::Detected> found() const;

 private:
  void end(const Steering& now);

  exec::Executor* executor_;
  SimTime began_ = 0;  ///< the last look at a floor sensor, as of the tick
  double from_m_ = 0.0;
  bool waits_ = false;               ///< in this stretch a call of Serial was seen waiting
  SimTime driven_ = 0, waited_ = 0;  ///< of all stretches
  int asked_ = 0, times_ = 0;
  double longest_s_ = 0.0, furthest_m_ = 0.0;
  exec::Activity first_;
  SimTime first_at_ = 0;
};

}  // namespace robosim::judge
