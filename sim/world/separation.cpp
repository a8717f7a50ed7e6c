#include "sim/world/separation.h"

#include <algorithm>

#include "sim/world/walls.h"

namespace robosim::world {
namespace {

constexpr double kBetween = Walls::kNear + 0.05;  // in metres; two bodies with a larger gap cannot meet

}  // namespace

const std::vector<bool>& Separation::find(const std::vector<std::unique_ptr<Body>>& bodies,
                                          const std::vector<double>& sights, double seconds) {
  rooms_.clear();
  double farthest = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = *bodies[i];
    const Vec2 centre = body.circle_centre();
    const double sight = sights[i] > 0.0 ? sights[i] + length(centre - body.pose().position) : 0.0;
    rooms_.push_back({centre, body.bound_radius() + body.reach(seconds), sight, i});
    farthest = std::max(farthest, sight);
  }
  const auto west = [](const Room& room) { return room.centre.x - room.radius; };
  std::sort(rooms_.begin(), rooms_.end(),
            [west](const Room& one, const Room& other) { return west(one) < west(other); });
  apart_.assign(bodies.size(), true);
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    const Room& one = rooms_[i];
    const double end = one.centre.x + one.radius + farthest + kBetween;
    for (std::size_t j = i + 1; j < rooms_.size() && west(rooms_[j]) < end; ++j) {
      const Room& other = rooms_[j];
      const double way = one.radius + other.radius + std::max(one.sight, other.sight) + kBetween;
      const Vec2 d = other.centre - one.centre;
      if (dot(d, d) < way * way) apart_[one.number] = apart_[other.number] = false;
    }
  }
  return apart_;
}

}  // namespace robosim::world
