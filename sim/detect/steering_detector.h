// Declares the base class of detectors that examine how a robot steers along its line.
#pragma once

#include <string>

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

/// The input of these detectors: the state of the robot at the end of a tick.
struct Steering {
  SimTime t = 0;
  SimTime sent_at = -1;     ///< time at which Serial last sent a byte; -1 = no byte yet
  double distance_m = 0.0;  ///< distance that the axle has travelled
  double travel_m = 0.0;    ///< distance that the wheels have turned
  double left = 0.0, right = 0.0;
  bool sees_line = false;
  bool on_its_own = true;   ///< the robot is switched on, and is not moved manually
  bool asks_floor = false;  ///< the firmware has read a floor sensor in this tick
};

class SteeringDetector : public FirmwareDetector {
 public:
  /// Examines the tick that ends at `now.t`.
  virtual void look(const Steering& now) = 0;
};

/// Returns the sketch's current call if the called function can wait; otherwise an empty text.
std::string waiting_call(const exec::Activity& activity);

/// The fix for a sketch that waits while it prints.
inline constexpr const char* kPrintLess =
    "Print less, less often, or with a faster Serial.begin(): printing waits until its buffer of 64 bytes "
    "has room.";

}  // namespace robosim::detect
