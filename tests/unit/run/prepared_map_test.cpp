#include "sim/run/prepared_map.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::run::prepared_map_test {

class PreparedMapTest : public testing::Test {
 protected:
  judge::Outcome follow(const Mission& mission, std::uint64_t seed,
                        std::unique_ptr<PreparedMap>* prepared_map) {
    test::BuiltInDriver driver;
    run::Setup setup;
    setup.map = &map_;
    setup.prepared_map = prepared_map;
    setup.agents = {{.robot = &robot_, .executor = &driver, .start = mission.start, .goal = mission.goal}};
    setup.limit = 2 * kSecond;
    setup.profile = Profile::typical_2;
    setup.seed = seed;
    return simulate(setup).front();
  }

  void expect_same(const judge::Outcome& a, const judge::Outcome& b) {
    EXPECT_EQ(a.trace_hash, b.trace_hash);
    EXPECT_EQ(a.why, b.why);
    EXPECT_EQ(a.goal, b.goal);
    EXPECT_EQ(a.metrics.distance_m, b.metrics.distance_m);
  }

  const map::Map map_ = map::read_map(map::find_map("city"));
  const robot::Description robot_ = robot::load_description("uno5");
};

TEST_F(PreparedMapTest, GivesTheSameResultAsAnUnpreparedRun) {
  const map::Start start = map::default_start(map_);
  const Mission missions[] = {
      {}, {start, {}}, {{}, judge::parse_goal("none")}, {start, judge::parse_goal("tour")}};
  for (const Mission& prepared : missions)
    for (const Mission& mission : missions)
      for (const std::uint64_t seed : {1, 7}) {
        auto prepared_map = std::make_unique<PreparedMap>(map_);
        prepared_map->prepare(0, prepared);
        expect_same(follow(mission, seed, &prepared_map), follow(mission, seed, nullptr));
        EXPECT_FALSE(prepared_map) << "the run takes the prepared map";
      }
}

TEST_F(PreparedMapTest, IsUsedByOneRunOnly) {
  auto prepared_map = std::make_unique<PreparedMap>(map_);
  const judge::Outcome first = follow({}, 3, &prepared_map);
  expect_same(follow({}, 3, &prepared_map), first);
}

TEST_F(PreparedMapTest, ReportsAnInvalidMissionInResolveNotInPrepare) {
  PreparedMap prepared_map(map_);
  const Mission nowhere{{}, judge::parse_goal("station:nowhere")};
  prepared_map.prepare(0, nowhere);
  EXPECT_THROW(prepared_map.resolve(0, nowhere), InputError);
  prepared_map.prepare(0, {});
  EXPECT_NO_THROW(prepared_map.resolve(0, {}));
}

}  // namespace robosim::run::prepared_map_test
