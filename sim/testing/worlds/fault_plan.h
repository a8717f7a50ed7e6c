// What breaks in a random world.
#pragma once

#include <string>
#include <vector>

#include "robosim/random_worlds.h"
#include "sim/testing/worlds/die.h"

namespace robosim::testing {

struct Fault {
  enum class Kind { offset, noisy, cover, weak, drift };
  static constexpr int kLevels = 10;

  Kind kind = Kind::offset;
  std::string part;  ///< "" for drift
  int at_ms = 0;
  int level = kLevels;    ///< how bad, from 1 to kLevels: as bad as the limits allow
  bool negative = false;  ///< offset, drift
};

struct FaultPlan {
  std::vector<Fault> faults;  ///< in the order of time

  std::vector<FaultPlan> smaller() const;
  std::string script(const Faults& limits) const;
};

/// What may break.
struct Breakable {
  std::vector<std::string> sensors, motors;
};
/// At most so many faults.
FaultPlan draw_up(const Faults& limits, int most, const Breakable& parts, const Die& die);

}  // namespace robosim::testing
