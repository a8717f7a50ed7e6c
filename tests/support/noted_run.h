// Runs one of Robosim's example sketches on a chip, and records the chip's state after each tick.
#pragma once

#include <stdlib.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/map/map.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/sum.h"
#include "tests/support/temporary_folder.h"

namespace robosim::run {

struct StockRun {
  const char* sketch;
  const char* robot;
  const char* map;
  SimTime limit;
};

class NotedRun final : public Listener {
 public:
  /// Runs the sketch. After each tick, stores the result of `note`, which returns the chip's state as a
  /// number.
  NotedRun(const StockRun& what, exec::Executor& executor, std::function<std::uint64_t()> note)
      : note_(std::move(note)) {
    const map::Map map = map::read_map(map::find_map(what.map));
    const robot::Description robot = robot::load_description(what.robot);
    run::Setup setup;
    setup.map = &map;
    setup.agents = {{.robot = &robot, .executor = &executor, .listener = this}};
    setup.limit = what.limit;
    setup.samples_every = kTick;
    trace_hash = simulate(setup).front().trace_hash;
  }

  /// Returns the sketch's image, built for the robot's board.
  static std::filesystem::path image_of(const StockRun& what, const std::string& target) {
    test::use_shared_cache();
    build::Request request{std::filesystem::path(ROBOSIM_EXAMPLES) / what.sketch,
                           *robot::load_description(what.robot).board};
    request.target = target;
    return build::build(request).image;
  }

  void sampled(const Sample&) override { ticks.push_back(note_()); }

  std::vector<std::uint64_t> ticks;
  std::string trace_hash;

 private:
  std::function<std::uint64_t()> note_;
};

inline void expect_same(const NotedRun& a, const NotedRun& b) {
  EXPECT_EQ(a.trace_hash, b.trace_hash);
  ASSERT_EQ(a.ticks.size(), b.ticks.size());
  for (std::size_t tick = 0; tick < a.ticks.size(); ++tick)
    ASSERT_EQ(a.ticks[tick], b.ticks[tick]) << "after " << tick << " ms";
}

}  // namespace robosim::run
