// Finds the robot to which an event of a run belongs.
#pragma once

#include "sim/wire/stream.h"

namespace robosim::wire {

/// Returns the robot's number; 0 for events of the run as a whole.
inline int agent_of(const Event& event) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.agent; })
          return one.agent;
        else
          return 0;
      },
      event);
}

}  // namespace robosim::wire
