// Defines the faults of a robot's parts that scripts can inject.
#pragma once

namespace robosim::robot {

class Breakable;
class Sensor;

/// All faults. Each part supports some of them. Scripts use the names of these enumerators.
enum class Failure { ok, dead, weak, reversed, stuck, swapped, noisy, offset, pressed, released };
const char* name_of(Failure failure);

/// One way in which a part can fail.
struct FaultKind {
  enum class Argument { none, number, sensor };

  Failure failure;
  const char* meaning;  ///< a description in one clause, for messages
  Argument argument = Argument::none;
  double least = 0.0;  ///< inclusive bounds of the number
  double most = 0.0;
};

/// A fault that a script requests, with its checked argument.
struct Fault {
  Failure failure = Failure::ok;
  double number = 0.0;
  Sensor* sensor = nullptr;
};

/// A fault and its part. The pointers are valid during the lifetime of the robot.
struct PartFault {
  Breakable* part = nullptr;
  Fault fault;
};

}  // namespace robosim::robot
