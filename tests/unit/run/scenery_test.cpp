#include "sim/run/scenery.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::run {
namespace {

class SceneryTest : public testing::Test {
 protected:
  judge::Outcome follow(const Errand& errand, std::uint64_t seed, std::unique_ptr<Scenery>* scenery) {
    test::BuiltInDriver driver;
    run::Setup setup;
    setup.map = &map_;
    setup.scenery = scenery;
    setup.agents = {{.robot = &robot_, .executor = &driver, .start = errand.start, .goal = errand.goal}};
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

  const grid::Map map_ = grid::read_map(grid::find_map("city"));
  const robot::Description robot_ = robot::load_description("uno5");
};

TEST_F(SceneryTest, IsWhatASimulationWouldMakeItself) {
  const grid::Start start = grid::default_start(map_);
  const Errand errands[] = {
      {}, {start, {}}, {{}, judge::parse_goal("none")}, {start, judge::parse_goal("tour")}};
  for (const Errand& prepared : errands)
    for (const Errand& errand : errands)
      for (const std::uint64_t seed : {1, 7}) {
        auto scenery = std::make_unique<Scenery>(map_);
        scenery->prepare(0, prepared);
        expect_same(follow(errand, seed, &scenery), follow(errand, seed, nullptr));
        EXPECT_FALSE(scenery) << "it is taken";
      }
}

TEST_F(SceneryTest, OfASetUpTheNextSimulationMakesItsOwn) {
  auto scenery = std::make_unique<Scenery>(map_);
  const judge::Outcome first = follow({}, 3, &scenery);
  expect_same(follow({}, 3, &scenery), first);
}

TEST_F(SceneryTest, AnErrandThatMakesNoSenseIsAnErrorOfTheRun) {
  Scenery scenery(map_);
  const Errand nowhere{{}, judge::parse_goal("station:nowhere")};
  scenery.prepare(0, nowhere);
  EXPECT_THROW(scenery.task(0, nowhere), InputError);
  scenery.prepare(0, {});
  EXPECT_NO_THROW(scenery.task(0, {}));
}

}  // namespace
}  // namespace robosim::run
