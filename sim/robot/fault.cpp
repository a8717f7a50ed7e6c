#include "sim/robot/fault.h"

namespace robosim::robot {

const char* name_of(Failure failure) {
  switch (failure) {
    case Failure::ok:
      break;
    case Failure::dead:
      return "dead";
    case Failure::weak:
      return "weak";
    case Failure::reversed:
      return "reversed";
    case Failure::stuck:
      return "stuck";
    case Failure::swapped:
      return "swapped";
    case Failure::noisy:
      return "noisy";
    case Failure::offset:
      return "offset";
    case Failure::pressed:
      return "pressed";
    case Failure::released:
      return "released";
  }
  return "ok";
}

}  // namespace robosim::robot
