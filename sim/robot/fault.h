// Faults of a robot's parts.
#pragma once

namespace robosim::robot {

class Breakable;
class Sensor;

/// All faults. Each part supports some of them; scripts use the same names.
enum class Failure { ok, dead, weak, reversed, stuck, swapped, noisy, offset, pressed, released };
const char* name_of(Failure failure);

/// One way in which a part can fail.
struct FaultKind {
  enum class Argument { none, number, sensor };

  Failure failure;
  const char* meaning;  ///< one clause, for lists
  Argument argument = Argument::none;
  double least = 0.0;  ///< bounds of a number, inclusive
  double most = 0.0;
};

/// A fault that a script requests, with its checked argument.
struct Fault {
  Failure failure = Failure::ok;
  double number = 0.0;
  Sensor* sensor = nullptr;
};

/// A fault and its part. Valid during the lifetime of the robot.
struct PartFault {
  Breakable* part = nullptr;
  Fault fault;
};

}  // namespace robosim::robot
