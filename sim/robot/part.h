// One part of a robot. It is wired to pins, drives them and observes them.
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
class FanPart;
class Mount;
class Sensor;
class ServoPart;
class WheelMotor;

/// A named object that scripts can break: a sensor, a motor, …
class Breakable {
 public:
  virtual const std::string& name() const = 0;
  virtual std::span<const FaultKind> fault_kinds() const = 0;
  /// `fault.failure` is one of fault_kinds(); it replaces the fault before.
  virtual void fail(const Fault& fault) = 0;

 protected:
  ~Breakable() = default;
};

/// An object that a finger presses: a button, a keypad's key.
class Pressable {
 public:
  virtual const std::string& name() const = 0;
  /// Pressed or released from `t` on.
  virtual void hold(bool down, SimTime t) = 0;
  /// The button that then wants begin_tick until it has settled; null = none does.
  virtual ButtonPart* bounces() { return nullptr; }

 protected:
  ~Pressable() = default;
};

/// An object that receives messages of scripts, by radio, light or Bluetooth.
class Receiver {
 public:
  virtual const std::string& name() const = 0;
  /// Throws InputError if it is nothing that this part can be sent.
  virtual void check(const Message&) const = 0;
  /// From `t` on, which is not before the current tick.
  virtual void send(const Message&, SimTime t) = 0;

 protected:
  ~Receiver() = default;
};

/// An object with text that people would see or hear.
class Teller {
 public:
  virtual const std::string& name() const = 0;
  /// What is new by `t`, the end of a tick; "" = nothing. Asked once a tick.
  virtual std::string tell(SimTime t) = 0;

 protected:
  ~Teller() = default;
};

class Part;

/// A sensor that detects other robots.
struct Lookout {
  const Mount* mount;
  double reach;  ///< m from there
};

/// The interfaces of the robot's parts. Each part registers itself.
struct Roster {
  std::vector<Part*> ticking;  ///< want begin_tick in every tick
  /// Want begin_tick only while the board wants edges, and in the first tick after: most firmware polls.
  std::vector<Part*> edge_makers;
  std::vector<Sensor*> sensors;  ///< floor sensors, in the file's order
  std::vector<Breakable*> breakable;
  std::vector<Pressable*> pressable;
  std::vector<Receiver*> receivers;
  std::vector<Teller*> tellers;
  std::vector<ServoPart*> servos;
  std::vector<FanPart*> fans;
  std::vector<Lookout> lookouts;
  bool has_radio = false;                     ///< hears other robots, wherever they are
  std::vector<Part*> supplied;                ///< have the board's supply, and want power()
  WheelMotor* motor[2] = {nullptr, nullptr};  ///< by world::Side
  bool differential = false;                  ///< the left one drives both wheels

  /// As Robot::sight().
  double sight() const;
  /// Whether begin_tick() of those that want it in every tick would do nothing.
  bool idles() const;
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
  /// Whether begin_tick() would do nothing until somebody does something to the part, or something touches
  /// the body.
  virtual bool idles() const { return false; }
  /// The board's supply is switched off or on again.
  virtual void power(bool on, SimTime) { static_cast<void>(on); }
  /// Appends what is shown of it, apart from floor sensors. Consumes no noise.
  virtual void read(std::vector<Reading>&) const {}
};

inline bool Roster::idles() const {
  for (const Part* part : ticking)
    if (!part->idles()) return false;
  return true;
}

}  // namespace robosim::robot
