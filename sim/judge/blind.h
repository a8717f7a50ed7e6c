// Blind time: a robot that drives on without a look at the line, and loses it.
//
//   digitalRead(middle);  analogWrite(left, 160); …  delay(400);        at 0.4 m/s: 160 mm that nobody saw
//
// Whatever keeps a sketch from its sensors does it: delay(), pulseIn() without a timeout, a print that waits
// until the 64 bytes of Serial's buffer have room, a loop that waits. On a straight it goes well. What is
// found is a stretch on which, from one look at a floor sensor to the next,
//
//   it drove further than its sensors are ahead of its axle, and the line is wide: from there on its wheels
//   are on floor that no sensor has ever been read on, and a bend that began meanwhile is behind it;
//   it had the line under its sensors when it looked, and at the end of the stretch had not;
//   and the motors were driven in the same way all along.
//
// The last leaves out who drives blind on purpose: to turn at a crossing, or round an obstacle, a sketch
// changes its motors' powers between two looks. What it cannot see: a sketch that reads its sensors and takes
// no notice; one that is blind on straights only; sensors behind a shift register, or read by interrupts.
//
// Mended by time that is asked for (millis()) in the place of delay(), shorter messages or a faster Serial,
// a timeout for pulseIn(), and a look at the sensors in each loop that waits.
#pragma once

#include <vector>

#include "sim/judge/floor_looks.h"

namespace robosim::judge {

class Blind {
 public:
  /// lever_m: how far its sensors are ahead of its axle.
  Blind(exec::Executor& executor, double lever_m, double line_m);

  void look(const Steering& now);
  /// At the end of the run.
  std::vector<exec::Detected> found() const;

 private:
  /// From one look of the sketch's at a sensor to the next.
  struct Stretch {
    SimTime began = 0;
    double from_m = 0.0;
    bool saw_line = false;
    bool planned = false;  ///< the motors' powers were changed meanwhile
    double left = 0.0, right = 0.0;
    int ticks = 0;
    bool is_too_long = false;
    exec::Activity busy;  ///< with what, when it became too long
  };

  void end(const Steering& now);
  exec::Detected told(const Steering& now) const;

  exec::Executor* executor_;
  double most_m_;
  int looks_ = 0;
  Steering before_;
  Stretch stretch_;
  std::vector<exec::Detected> found_;
};

}  // namespace robosim::judge
