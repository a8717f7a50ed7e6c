// A test fixture that moves a robot of 60 mm radius over a map manually, and evaluates the map's goal.
#pragma once

#include <string>

#include "sim/judge/goal.h"
#include "sim/world/body.h"
#include "sim/world/world.h"

namespace robosim::judge {

struct HandMoved {
  /// Puts the robot on the map's default start. If `goal` is "", uses the map's goal.
  explicit HandMoved(const std::string& text, const std::string& goal = "")
      : map(map::parse_map(text, "test.map")),
        start(map::default_start(map)),
        network(map::trace_network(map, start)),
        stripes(map, map.cell_m),
        world(map),
        body(world.body(world.add_body(params(), stripes.pose_of(start)))),
        progress(goal.empty() ? default_goal(map, network) : parse_goal(goal), map, stripes, network, start) {
  }

  static world::BodyParams params() {
    world::BodyParams p = world::default_body_params();
    p.outline.clear();
    p.radius_m = 0.060;
    p.centre = {};
    return p;
  }
  void put(Vec2 at) {
    body.place({at, {1.0, 0.0}});
    look();
  }
  /// Moves the robot straight to `to`, by `step_m` in each tick of 1 ms.
  void push(Vec2 to, double step_m = 0.001) {
    const Vec2 from = body.pose().position;
    const double way = length(to - from);
    for (double gone = step_m; gone <= way; gone += step_m) put(from + (to - from) * (gone / way));
  }
  void wait(SimTime duration) {
    for (const SimTime end = now + duration; now < end;) look();
  }
  void look() { progress.update(body, now += kTick, events); }
  result::Metrics score() const {
    result::Metrics metrics;
    progress.score(metrics);
    return metrics;
  }
  std::string summary() const { return progress.summary(); }

  map::Map map;
  map::Start start;
  map::Network network;
  map::Stripes stripes;
  world::World world;
  world::Body& body;
  Progress progress;
  SimTime now = 0;
  Events events;
};

}  // namespace robosim::judge
