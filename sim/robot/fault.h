// What can be wrong with a robot's parts.
#pragma once

namespace robosim::robot {

class Breakable;
class Sensor;

/// Each part knows some of these; scripts call them by the same names.
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

/// A fault that a script asks for, its argument read and checked.
struct Fault {
  Failure failure = Failure::ok;
  double number = 0.0;
  Sensor* sensor = nullptr;
};

/// A fault and whose it is. Valid as long as the robot.
struct PartFault {
  Breakable* part = nullptr;
  Fault fault;
};

}  // namespace robosim::robot
