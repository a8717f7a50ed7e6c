// Checks the stop conditions of a leg that concern one agent (step_controller.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/judge/goal.h"
#include "sim/robot/robot.h"
#include "sim/run/line_pattern.h"
#include "sim/run/step_controller.h"
#include "sim/world/world.h"

namespace robosim::run {

class StopConditions {
 public:
  /// The state that stop conditions examine. All of this state must outlive the StopConditions.
  struct Scene {
    const std::string& serial;
    const judge::Progress& progress;
    const world::Body& body;
    const robot::Robot& robot;
    const RobotPort& board;
    int agent;  ///< number of this agent; other agents check the stops that concern them
  };

  explicit StopConditions(const Scene& scene) : scene_(scene) {}

  /// Throws InputError if a stop has an unknown name.
  void check(const Leg& leg) const;
  /// Begins a leg at `t`. check() must have accepted it.
  void begin(const Leg& leg, SimTime t);
  void pin_changed(Pin pin, const PinDrive& drive);
  void happened(const result::RunEvent& event);
  /// Returns whether the leg ends at `t`. Call it at the end of each tick.
  bool look(SimTime t);
  /// Returns the number of the first stop that ended the leg, or -1.
  int met() const { return state_.met; }

  struct Watch {
    Stop stop;
    int number = 0;           ///< number of the stop in the leg
    std::size_t station = 0;  ///< index into Progress::stations()
    Pin pin = kNoPin;
    std::optional<LinePattern> line;
    std::size_t searched = 0;  ///< bytes of the serial text that have been searched already
    SimTime rest_since = 0;
    bool met = false;
  };
  /// The state that changes during a run.
  struct State {
    std::vector<Watch> watches;
    SimTime until = 0;
    int met = -1;
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  Watch watch_for(const Stop& stop) const;
  bool is_met(Watch& watch, SimTime t) const;
  bool says(Watch& watch) const;
  bool says_line(Watch& watch) const;

  const Scene scene_;
  State state_;
};

}  // namespace robosim::run
