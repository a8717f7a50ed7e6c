// Declares the interfaces of a robot's parts. A part is wired to pins, which it drives or observes.
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
  /// Applies a fault, which replaces any earlier fault. `fault.failure` is one of fault_kinds().
  virtual void fail(const Fault& fault) = 0;

 protected:
  ~Breakable() = default;
};

/// An object that a finger presses: a button, a keypad's key.
class Pressable {
 public:
  virtual const std::string& name() const = 0;
  /// Presses or releases the object from `t` on.
  virtual void hold(bool down, SimTime t) = 0;
  /// Returns the button whose contact may bounce after hold(); null = none. The robot calls the button's
  /// begin_tick() until the contact has settled.
  virtual ButtonPart* bounces() { return nullptr; }

 protected:
  ~Pressable() = default;
};

/// An object that receives messages of scripts, by radio, light or Bluetooth.
class Receiver {
 public:
  virtual const std::string& name() const = 0;
  /// Throws InputError if this part cannot receive the message.
  virtual void check(const Message&) const = 0;
  /// Starts the delivery of the message at `t`, which is in the current tick or later.
  virtual void send(const Message&, SimTime t) = 0;

 protected:
  ~Receiver() = default;
};

/// An object with text that people would see or hear.
class TextOutput {
 public:
  virtual const std::string& name() const = 0;
  /// Returns the new text at `t`, the end of a tick; "" = none. The robot calls this
  /// function once per tick.
  virtual std::string poll_text(SimTime t) = 0;

 protected:
  ~TextOutput() = default;
};

class Part;

/// The mount and the reach of a sensor that detects other robots.
struct Sightline {
  const Mount* mount;
  double reach;  ///< m from the mount
};

/// The robot's parts, listed by interface. Each part registers itself.
struct PartRegistry {
  std::vector<Part*> ticking;  ///< parts that need begin_tick() in every tick
  /// Parts that need begin_tick() only while the board requests edges, and in the first tick after that. Most
  /// firmware polls, and needs no edges.
  std::vector<Part*> edge_makers;
  std::vector<Sensor*> sensors;  ///< floor sensors, in the file's order
  std::vector<Breakable*> breakable;
  std::vector<Pressable*> pressable;
  std::vector<Receiver*> receivers;
  std::vector<TextOutput*> text_outputs;
  std::vector<ServoPart*> servos;
  std::vector<FanPart*> fans;
  std::vector<Sightline> sightlines;
  bool has_radio = false;                     ///< the robot receives messages of other robots at any distance
  std::vector<Part*> supplied;                ///< parts on the board's supply: the robot calls their power()
  WheelMotor* motor[2] = {nullptr, nullptr};  ///< by world::Side
  bool differential = false;                  ///< the left motor drives both wheels

  /// Computes the result of Robot::sight().
  double sight() const;
  /// Returns whether begin_tick() of the ticking parts would do nothing.
  bool idles() const;
};

class Part {
 public:
  virtual ~Part() = default;
  /// Registers the part. The robot calls this function once, when all parts exist.
  virtual void register_with(PartRegistry&) = 0;
  /// Finds the part on which this part is mounted. The robot calls this function once, when all parts are
  /// registered.
  virtual void resolve_mounts(const PartRegistry&) {}
  /// Schedules the pin edges of the tick that begins at `t`, from the world's state at `t`.
  virtual void begin_tick(SimTime) {}
  /// Returns whether begin_tick() does nothing until something acts on the part, or touches the body.
  virtual bool idles() const { return false; }
  /// Handles a switch-off or switch-on of the board's supply.
  virtual void power(bool on, SimTime) { static_cast<void>(on); }
  /// Appends the part's displayed readings, except those of floor sensors. Consumes no noise.
  virtual void read(std::vector<Reading>&) const {}
};

inline bool PartRegistry::idles() const {
  for (const Part* part : ticking)
    if (!part->idles()) return false;
  return true;
}

}  // namespace robosim::robot
