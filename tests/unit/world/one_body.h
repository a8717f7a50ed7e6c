// A test fixture with a body on an empty floor.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "maps.h"
#include "sim/world/world.h"

namespace robosim::world {

class OneBodyTest : public testing::Test {
 protected:
  explicit OneBodyTest(int cells = 400) : map_(empty_map(cells, cells)) {}

  /// Creates a new world with a body, which faces east in the middle of the floor.
  Body& make(const BodyParams& params = default_body_params()) {
    return make(params, {{0.05 * map_.width, 0.05 * map_.height}, {1.0, 0.0}});
  }
  Body& make(const BodyParams& params, const Pose& pose) {
    world_ = std::make_unique<World>(map_);
    return world_->body(world_->add_body(params, pose));
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 1000.0 + 0.5); ++i) world_->step();
  }
  static void drive(Body& body, double left_drive, double right_drive) {
    body.command(left, {left_drive, 0.0});
    body.command(right, {right_drive, 0.0});
  }
  static void drive(Body& body, double share) { drive(body, share, share); }

  map::Map map_;
  std::unique_ptr<World> world_;
};

}  // namespace robosim::world
