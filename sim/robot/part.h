// One part of a robot: wired to pins, it drives them and watches them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/robot/description.h"
#include "sim/robot/fault.h"
#include "sim/robot/robot.h"

namespace robosim::robot {

class ButtonPart;
class RadioPart;
class Sensor;
class ServoPart;
class WheelMotor;

/// Something with a name that scripts can break: a sensor, a motor, …
class Breakable {
 public:
  virtual const std::string& name() const = 0;
  virtual std::span<const FaultKind> fault_kinds() const = 0;
  /// `fault.failure` is one of fault_kinds(); it replaces the fault before.
  virtual void fail(const Fault& fault) = 0;

 protected:
  ~Breakable() = default;
};

class Part;

/// What the robot's parts offer; each part registers itself.
struct Roster {
  std::vector<Part*> ticking;  ///< want begin_tick in every tick
  /// Want begin_tick only while the board wants edges, and in the first tick after: most firmware polls.
  std::vector<Part*> edge_makers;
  std::vector<Sensor*> sensors;  ///< floor sensors, in the file's order
  std::vector<Breakable*> breakable;
  std::vector<ButtonPart*> buttons;
  std::vector<RadioPart*> radios;
  std::vector<ServoPart*> servos;
  std::vector<Part*> supplied;                ///< have the board's supply, and want power()
  WheelMotor* motor[2] = {nullptr, nullptr};  ///< by world::Side
};

class Part {
 public:
  virtual ~Part() = default;
  /// Called once, when all parts exist.
  virtual void join(Roster&) = 0;
  /// Called once, when all have joined: to find the part that it sits on.
  virtual void meet(const Roster&) {}
  /// Schedules the pin edges of the tick that begins at `t`, from the world's state at `t`.
  virtual void begin_tick(SimTime) {}
  /// The board's supply is switched off or on again.
  virtual void power(bool on, SimTime) { static_cast<void>(on); }
  /// Appends what is shown of it, apart from floor sensors. Consumes no noise.
  virtual void read(std::vector<Reading>&) const {}
};

}  // namespace robosim::robot
