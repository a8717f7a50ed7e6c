// Provides the input of the steering detectors in each tick: the firmware's reads of floor sensors, and the
// robot's motion.
#pragma once

#include <string>
#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/robot/robot.h"

namespace robosim::judge {

struct Steering {
  SimTime t = 0;
  SimTime sent_at = -1;     ///< time of Serial's last byte; -1 = none
  double distance_m = 0.0;  ///< distance that the axle has travelled
  double travel_m = 0.0;    ///< distance that the wheels have turned
  double left = 0.0, right = 0.0;
  bool sees_line = false;
  bool on_its_own = true;   ///< switched on, and not moved manually
  bool asks_floor = false;  ///< firmware has read a floor sensor in this tick
};

/// Returns the call in which firmware waits; empty if the current call never waits, or there is none.
std::string waiting_call(const exec::Activity& activity);

/// The fix for a sketch that waits while it prints.
inline constexpr const char* kPrintLess =
    "Print less, less often, or with a faster Serial.begin(): printing waits until its buffer of 64 bytes "
    "has room.";

class FloorLooks {
 public:
  FloorLooks(const robot::Robot& robot, exec::Executor& executor);

  /// Returns whether reads are visible: the robot has floor sensors, and each is wired to a pin of the board.
  bool are_known() const { return !pins_.empty(); }
  /// Returns the time of the firmware's last read of a floor sensor; -1 = never. Returns `now` if an
  /// interrupt waits for a sensor's edges.
  SimTime last(SimTime now) const;

 private:
  exec::Executor* executor_;
  std::vector<Pin> pins_;
};

}  // namespace robosim::judge
