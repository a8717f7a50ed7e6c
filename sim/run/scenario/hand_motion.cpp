#include "sim/run/scenario/hand_motion.h"

#include <algorithm>

#include "sim/base/trig_series.h"

namespace robosim::scenario {

Pose Sweep::at(SimTime t) const {
  const double phase = static_cast<double>((t - began) % period) / static_cast<double>(period);
  const double aside = phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
  return {base.position + left_of(base.heading) * (aside * reach), base.heading};
}

world::Lean Tilt::at(SimTime t) const {
  const SimTime since = t - began, left = end - t;
  const double rate = angle / (1e-9 * static_cast<double>(way));
  const double share = static_cast<double>(std::min({since, left, way})) / static_cast<double>(way);
  const double growing = since < way ? rate : left <= way ? -rate : 0.0;
  const Vec2 direction = direction_of(share * angle);
  return {side * direction.y, direction.x, side * growing};
}

}  // namespace robosim::scenario
