// Tests that the physics gives the same bits in every build.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <new>

#include "maps.h"
#include "sim/world/world.h"

namespace robosim::world::determinism_test {

// Computes FNV-1a over the bits of doubles.
struct Bits {
  std::uint64_t hash = 14695981039346656037u;
  void add(double value) {
    for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), i = 0; i < 8; ++i, bits >>= 8) {
      hash = (hash ^ (bits & 255)) * 1099511628211u;
    }
  }
};

// Two bodies drive into walls, into each other and into an obstacle. They also slip and brake. The test also
// reads the floor. If the hash changes, old runs can no longer be reproduced, so the change must be
// announced. The hash is the same for gcc and clang at any optimisation.
TEST(Determinism, TheBitsOfAMixedRunArePinned) {
  map::Map map =
      map_of({"##############", "#            #", "# .......... #", "# .   #    . #", "# .  oo..  x #",
              "# .    .   . #", "# .......... #", "#            #", "##############"});
  World world(map);
  BodyParams box = default_body_params();
  box.outline = {{-0.05, -0.05}, {0.08, -0.05}, {0.08, 0.05}, {-0.05, 0.05}};
  box.grip = 0.25;
  Body& a = world.body(world.add_body(default_body_params(), {{0.25, 0.25}, {1.0, 0.0}}));
  Body& b = world.body(world.add_body(box, {{1.05, 0.65}, {-0.6, 0.8}}));
  Bits bits;
  unsigned random = 11;
  for (int tick = 0; tick < 30000; ++tick) {
    if (tick % 200 == 0) {
      for (Body* body : {&a, &b}) {
        for (const Side side : {left, right}) {
          random = random * 1664525u + 1013904223u;
          body->command(side, {static_cast<int>(random >> 8 & 255) / 160.0 - 0.5, (random >> 20 & 3) / 3.0});
        }
      }
    }
    if (tick == 10000) world.add_obstacle({0.6, 0.3}, 0.04);
    if (tick == 20000) world.remove_obstacle(1);
    world.step();
    for (const Body* body : {&a, &b}) {
      const Vec2 sensor = body->pose_after(0.0003).to_world({0.06, 0.01});
      bits.add(body->pose().position.x);
      bits.add(body->pose().position.y);
      bits.add(body->pose().heading.x);
      bits.add(body->wheel_angle(left));
      bits.add(body->energy());
      bits.add(world.floor().on_line(sensor, 0.003));
      bits.add(world.floor().distance_to_line(sensor));
    }
  }
  EXPECT_GT(a.collisions() + b.collisions(), 10);
  EXPECT_EQ(bits.hash, 12569182467989404639u);
}

// The previous content of the memory in which a body is created must have no effect.
TEST(Determinism, ABodyOwesNothingToTheMemoryItIsMadeIn) {
  BodyParams box = default_body_params();
  box.outline = {{-0.05, -0.05}, {0.08, -0.05}, {0.08, 0.05}, {-0.05, 0.05}};
  alignas(Body) unsigned char memory[2][sizeof(Body)];
  std::memset(memory[0], 0x00, sizeof memory[0]);
  std::memset(memory[1], 0x7E, sizeof memory[1]);  // doubles of about 1e301
  Body* clean = new (memory[0]) Body(box, {{0.5, 0.5}, {1.0, 0.0}});
  Body* used = new (memory[1]) Body(box, {{0.5, 0.5}, {1.0, 0.0}});
  EXPECT_EQ(clean->bound_radius(), used->bound_radius());
  EXPECT_NEAR(used->bound_radius(), length({0.065, 0.05}), 1e-12);
  clean->~Body();
  used->~Body();
}

}  // namespace robosim::world::determinism_test
