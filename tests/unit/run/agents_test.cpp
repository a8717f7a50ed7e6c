// Tests several robots in one simulation. Each robot has its own firmware, script, goal and verdict. The
// robots share the clock and the floor.

#include <gmock/gmock.h>

#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::run::agents_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Witness final : Listener {
  void happened(const result::RunEvent& event) override { events.push_back(event); }
  std::vector<std::string> kinds() const {
    std::vector<std::string> names;
    for (const result::RunEvent& event : events) names.push_back(result::kind_of(event));
    return names;
  }
  std::vector<result::RunEvent> events;
};

using Parked = test::FakeFirmware;

/// Firmware that drives straight ahead.
class Straight final : public test::FakeFirmware {
 public:
  void power_on(SimTime t) override { drive(0.3, 0.3, t); }
};

class AgentsTest : public testing::Test {
 protected:
  AgentSetup agent(exec::Executor& firmware, const char* goal, const std::string& start = "",
                   const std::string& script = "") {
    AgentSetup setup;
    setup.robot = &robot_;
    setup.executor = &firmware;
    setup.goal = judge::parse_goal(goal);
    if (!start.empty()) setup.start = map::parse_start(map_, start);
    setup.scenario = scenario::parse_scenario(script, "s.txt");
    return setup;
  }
  std::vector<judge::Outcome> run(std::vector<AgentSetup> agents, SimTime limit = 20 * kSecond) {
    run::Setup setup;
    setup.map = &map_;
    setup.agents = std::move(agents);
    setup.limit = limit;
    return simulate(setup);
  }

  map::Map map_ = map::read_map(map::find_map("oval"));
  robot::Description robot_ = robot::load_description("uno5");
  test::BuiltInDriver driver_, other_;
  Parked parked_;
};

TEST_F(AgentsTest, CollideOnOneFloorAndEachHasItsOwnGoalAndVerdict) {
  const judge::Outcome alone = run({agent(other_, "laps:1")}).front();
  Witness moving, standing;
  AgentSetup first = agent(driver_, "laps:1");
  AgentSetup second = agent(parked_, "laps:2", "20,2,E");
  first.listener = &moving;
  second.listener = &standing;

  const std::vector<judge::Outcome> outcomes = run({first, second});

  ASSERT_EQ(outcomes.size(), 2u);
  EXPECT_EQ(outcomes[0].verdict, judge::Verdict::reached) << outcomes[0].why;
  EXPECT_EQ(outcomes[1].verdict, judge::Verdict::timeout) << outcomes[1].why;
  EXPECT_EQ(outcomes[1].time, 20 * kSecond) << "the run continues after the other robot's verdict";
  EXPECT_GT(outcomes[0].time, alone.time) << "the first robot had to push the second one away";
  EXPECT_GT(outcomes[1].metrics.distance_m, 0.01) << "the second robot was pushed";
  ASSERT_THAT(moving.kinds(), ElementsAre("collision_began", "lap_done"));
  ASSERT_THAT(standing.kinds(), Contains("collision_began"));
  EXPECT_EQ(moving.events[0].agent, 0);
  EXPECT_EQ(standing.events[0].agent, 1);
  EXPECT_EQ(moving.events[0].t_ns, standing.events[0].t_ns);
  EXPECT_TRUE(std::get<result::CollisionBegan>(moving.events[0].what).with_robot);
  EXPECT_NE(outcomes[0].trace_hash, outcomes[1].trace_hash);
}

TEST_F(AgentsTest, ThatPushAgainstEachOtherAreStuckAtAnotherRobot) {
  Straight east, west;
  run::Setup setup;
  setup.map = &map_;
  setup.agents = {agent(east, "none", "14,2,E"), agent(west, "none", "18,2,W")};
  setup.limit = 20 * kSecond;
  setup.profile = Profile::ideal;
  for (const judge::Outcome& one : simulate(setup)) {
    EXPECT_EQ(one.verdict, judge::Verdict::stuck) << one.why;
    EXPECT_THAT(one.why, HasSubstr("another robot ("));
  }
}

TEST_F(AgentsTest, ThatPushAgainstAnObstructionNameIt) {
  const auto why = [&](const char* rows) {
    map_ = map::parse_map(rows, "m.map");
    Straight straight;
    return run({agent(straight, "none", "3,2,E")}).front().why;
  };
  EXPECT_THAT(why("_________\n_________\n__S11111x\n_________\n_________\n"),
              HasSubstr("pushed against an obstacle, "));
  EXPECT_THAT(why("________#\n________#\n__S11111#\n________#\n________#\n"),
              HasSubstr("pushed against a wall, "));
  EXPECT_THAT(why("_________\n_________\n__S111111\n_________\n_________\n"),
              HasSubstr("pushed against the map's edge, "));
}

TEST_F(AgentsTest, ThatNeverStopSayHowFarTheirGoalIs) {
  const judge::Outcome drives = run({agent(driver_, "still")}, 2 * kSecond).front();
  EXPECT_THAT(drives.why, AllOf(HasSubstr("it moved, but did not stop for 1 s"), Not(HasSubstr("never"))));
  const judge::Outcome stands = run({agent(parked_, "still")}, 2 * kSecond).front();
  EXPECT_THAT(stands.why, AllOf(HasSubstr("before the goal still: it never moved"), Not(HasSubstr("stop"))));
}

TEST_F(AgentsTest, ThatNeverMeetLeaveEachOthersRunAsItIsAlone) {
  const judge::Outcome alone = run({agent(other_, "laps:1")}).front();
  ASSERT_EQ(alone.verdict, judge::Verdict::reached) << alone.why;

  // The script lifts the second robot, so the robots cannot meet.
  const std::vector<judge::Outcome> both =
      run({agent(driver_, "laps:1"), agent(parked_, "none", "20,2,E", "at 0s lift\n")});

  EXPECT_EQ(both[0].trace_hash, alone.trace_hash);
  EXPECT_EQ(both[0].time, alone.time);
}

TEST_F(AgentsTest, AreDifferentIndividualsWithTheirOwnNoise) {
  const judge::Outcome first = run({agent(driver_, "none")}, kSecond).front();
  const std::vector<judge::Outcome> both =
      run({agent(parked_, "none", "20,2,E", "at 0s lift\n"), agent(other_, "none")}, kSecond);
  EXPECT_NE(both[1].trace_hash, first.trace_hash) << "robots 0 and 1 of one seed differ";
}

TEST_F(AgentsTest, MeetInTheSameWayWhoeverIsNamedFirst) {
  const robot::Description heavier = robot::load_description("uno3");
  const auto hashes = [&](bool swapped) {
    test::BuiltInDriver driver;
    Parked parked;
    std::vector<AgentSetup> agents = {agent(driver, "none"), agent(parked, "none", "20,2,E")};
    agents[1].robot = &heavier;
    if (swapped) std::swap(agents[0], agents[1]);
    run::Setup setup;
    setup.map = &map_;
    setup.agents = agents;
    setup.limit = 10 * kSecond;
    setup.profile = Profile::ideal;
    std::vector<judge::Outcome> outcomes = simulate(setup);
    if (swapped) std::swap(outcomes[0], outcomes[1]);
    EXPECT_GT(outcomes[1].metrics.collisions, 0);
    return outcomes[0].trace_hash + " " + outcomes[1].trace_hash;
  };
  EXPECT_EQ(hashes(false), hashes(true)) << "without noise, which depends on the robot's number";
}

TEST_F(AgentsTest, HaveScriptsThatBreakTheirOwnPartsOnly) {
  Witness broken, whole;
  AgentSetup first = agent(driver_, "none", "", "at 100ms fault S1 stuck 1023\n");
  AgentSetup second = agent(parked_, "none", "20,2,E");
  first.listener = &broken;
  second.listener = &whole;
  run({first, second}, 200 * kMillisecond);
  EXPECT_THAT(broken.kinds(), ElementsAre("fault_began"));
  EXPECT_THAT(whole.kinds(), IsEmpty());
}

TEST_F(AgentsTest, GiveTheSameRunTwice) {
  const auto race = [&] {
    test::BuiltInDriver a, b;
    return run({agent(a, "laps:1"), agent(b, "laps:1", "20,2,W")});
  };
  const std::vector<judge::Outcome> once = race(), again = race();
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].trace_hash, again[i].trace_hash);
}

/// Stops the run when the first robot has visited a station, or the second robot has collided.
struct Referee final : StepController {
  Leg next(Standstill& standstill) override {
    agents = standstill.agent_count();
    if (legs++ > 0) {
      met = standstill.state(1).stop;
      at = standstill.state(1).t;
      return {.end = true};
    }
    Leg leg;
    leg.stops.push_back({.kind = Stop::Kind::event, .text = "station_visited", .agent = 0});
    leg.stops.push_back({.kind = Stop::Kind::event, .text = "collision_began", .agent = 1});
    standstill.check(leg);
    return leg;
  }
  int legs = 0, agents = 0, met = -1;
  SimTime at = 0;
};

TEST_F(AgentsTest, AreDrivenStepByStepTogetherAndStopsSayWhomTheyAreAbout) {
  Referee referee;
  Witness standing;
  run::Setup setup;
  setup.map = &map_;
  setup.agents = {agent(driver_, "laps:1"), agent(parked_, "none", "20,2,E")};
  setup.agents[1].listener = &standing;
  setup.controller = &referee;
  const std::vector<judge::Outcome> outcomes = simulate(setup);
  EXPECT_EQ(referee.agents, 2);
  EXPECT_EQ(referee.met, 1) << "the second stop, which is about the second robot";
  ASSERT_EQ(standing.events.size(), 1u);
  EXPECT_EQ(referee.at, standing.events[0].t_ns);
  for (const judge::Outcome& outcome : outcomes) EXPECT_EQ(outcome.verdict, judge::Verdict::interrupted);
}

TEST_F(AgentsTest, CannotBeSavedWhereTheirFirmwareCannot) {
  run::Setup setup;
  setup.map = &map_;
  setup.agents = {agent(driver_, "none")};
  Simulation simulation(setup);
  EXPECT_THAT([&] { simulation.save(); }, testing::ThrowsMessage<InputError>(
                                              testing::HasSubstr("saving a run requires an emulated chip")));
}

}  // namespace robosim::run::agents_test
