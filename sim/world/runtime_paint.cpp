#include "sim/world/runtime_paint.h"

#include <algorithm>

namespace robosim::world {
namespace {

/// Returns the share of an interval of `width` about `at` that lies between `least` and `most`.
double share_between(double least, double most, double at, double width) {
  if (at - 0.5 * width >= least && at + 0.5 * width <= most) return 1.0;
  const double from = std::max(at - 0.5 * width, least), to = std::min(at + 0.5 * width, most);
  return std::clamp((to - from) / width, 0.0, 1.0);
}

}  // namespace

int RuntimePaint::add(Vec2 least, Vec2 most, bool line) {
  ++state_.changes;
  state_.patches.push_back({state_.next_id, least, most, line});
  return state_.next_id++;
}

void RuntimePaint::remove(int id) {
  ++state_.changes;
  std::erase_if(state_.patches, [id](const Rectangle& patch) { return patch.id == id; });
}

double RuntimePaint::over(double below, double line, double bare, Vec2 p, double footprint) const {
  const double width = std::max(footprint, 1e-9);
  for (const Rectangle& patch : state_.patches) {
    const double share = share_between(patch.least.x, patch.most.x, p.x, width) *
                         share_between(patch.least.y, patch.most.y, p.y, width);
    below += share * ((patch.line ? line : bare) - below);
  }
  return below;
}

}  // namespace robosim::world
