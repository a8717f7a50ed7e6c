// Tests the conditions that end a step, in runs that a StepController advances step by step.

#include <gmock/gmock.h>

#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::run {
namespace stop_conditions_test {

using testing::HasSubstr;

/// The built-in driver, which also sends `text`: one byte per millisecond from the start of the run.
class Talker final : public exec::Executor {
 public:
  explicit Talker(std::string text) : text_(std::move(text)) {}
  RobotPort& board() override { return driver_.board(); }
  exec::BoardProbe& probe() override { return driver_.probe(); }
  void power_on(SimTime t) override { driver_.power_on(t); }
  void power_off(SimTime t) override { driver_.power_off(t); }
  void run_until(SimTime t) override {
    if (said_ < text_.size()) static_cast<exec::BoardState&>(board()).send_byte(text_[said_++], t - kTick);
    driver_.run_until(t);
  }
  const std::optional<exec::Crash>& crash() const override { return driver_.crash(); }
  exec::Activity activity() override { return {}; }
  SimTime last_call() const override { return driver_.last_call(); }

 private:
  std::string text_;
  std::size_t said_ = 0;
  test::BuiltInDriver driver_;
};

/// Continues the run once, until a stop condition of `leg` is met, or until `leg.until`. Then ends the run.
struct OneLeg final : StepController {
  Leg next(Standstill& standstill) override {
    if (went_on) {
      met = standstill.state().stop;
      at = standstill.state().t;
      return {.end = true};
    }
    went_on = true;
    try {
      standstill.check(leg);
    } catch (const InputError& error) {
      refused = error.what();
      return {.end = true};
    }
    return leg;
  }
  Leg leg;
  bool went_on = false;
  std::string refused;
  int met = -1;
  SimTime at = 0;
};

class StopConditionsTest : public testing::Test {
 protected:
  OneLeg drive(std::vector<Stop> stops, const std::string& says = "", const std::string& script = "",
               SimTime until = 3 * kSecond) {
    const map::Map map = map::read_map(map::find_map("oval"));
    const robot::Description robot = robot::load_description("uno5");
    Talker talker(says);
    OneLeg controller;
    controller.leg = {.until = until, .stops = std::move(stops)};
    run::Setup setup;
    setup.map = &map;
    setup.agents = {{.robot = &robot,
                     .executor = &talker,
                     .goal = judge::parse_goal("none"),
                     .scenario = scenario::parse_scenario(script, "s.txt")}};
    setup.limit = 10 * kSecond;
    setup.controller = &controller;
    simulate(setup);
    return controller;
  }
};

TEST_F(StopConditionsTest, TheLegEndsWhenItsTimeIsUpIfNothingWasMet) {
  const OneLeg leg = drive({{.kind = Stop::Kind::serial, .text = "never said"}}, "", "", 250 * kMillisecond);
  EXPECT_EQ(leg.met, -1);
  EXPECT_EQ(leg.at, 250 * kMillisecond);
}

TEST_F(StopConditionsTest, WhatTheSketchSaysIsNoEvent) {
  const OneLeg leg = drive({{.kind = Stop::Kind::event, .text = "collision_began"},
                            {.kind = Stop::Kind::note, .text = "collision"},
                            {.kind = Stop::Kind::line, .text = "^collision"}},
                           "collision with a wall, an obstacle or the map's edge\n");
  EXPECT_EQ(leg.met, 2) << "the line was met, the collision was not";
}

TEST_F(StopConditionsTest, AnEventIsMetInTheTickInWhichItHappens) {
  const OneLeg leg = drive({{.kind = Stop::Kind::event, .text = "fault_began"}}, "",
                           "at 100ms press start\nat 200ms fault S1 stuck 5\n");
  EXPECT_EQ(leg.met, 0);
  EXPECT_EQ(leg.at, 201 * kMillisecond);
}

TEST_F(StopConditionsTest, ATextIsHeardAcrossBytesAndFromTheByteThatCounts) {
  EXPECT_EQ(drive({{.kind = Stop::Kind::serial, .text = "ready"}}, "not ready yet").at, 9 * kMillisecond);
  EXPECT_EQ(drive({{.kind = Stop::Kind::serial, .text = "e", .from = 6}}, "ready ready").at,
            8 * kMillisecond);
}

TEST_F(StopConditionsTest, APatternTakesNoMoreTimeThanThereIsTextWhateverItIs) {
  const std::string line = std::string(200, 'a') + "b\n";
  EXPECT_EQ(drive({{.kind = Stop::Kind::line, .text = "^(a+)+$"}}, line, "", 300 * kMillisecond).met, -1);
  EXPECT_EQ(drive({{.kind = Stop::Kind::line, .text = "^(a+)+b$"}}, line, "", 300 * kMillisecond).met, 0);
  EXPECT_EQ(drive({{.kind = Stop::Kind::line, .text = "^\xFF\\d{2}$"}},
                  "\xFF"
                  "42\r\n")
                .met,
            0)
      << "patterns match bytes";
  EXPECT_THAT(drive({{.kind = Stop::Kind::line, .text = "(a)\\1"}}).refused,
              HasSubstr("expected one that runs in linear time"));
}

TEST_F(StopConditionsTest, OfTwoThatAreMetInOneTickTheFirstCounts) {
  EXPECT_EQ(drive({{.kind = Stop::Kind::motors, .level = true}, {.kind = Stop::Kind::pin, .text = "D5"}}).met,
            0);
}

TEST_F(StopConditionsTest, NamesThatDoNotExistAreRefusedWithThoseThatDo) {
  EXPECT_THAT(drive({{.kind = Stop::Kind::reading, .text = "S9"}}).refused, HasSubstr("S1"));
  EXPECT_THAT(drive({{.kind = Stop::Kind::pin, .text = "D99"}}).refused, HasSubstr("uno has no pin D99"));
  EXPECT_THAT(drive({{.kind = Stop::Kind::line, .text = "("}}).refused,
              HasSubstr("invalid regular expression"));
  EXPECT_THAT(drive({{.kind = Stop::Kind::event, .text = "collision"}}).refused,
              HasSubstr("collision_began"));
  EXPECT_THAT(drive({{.kind = Stop::Kind::motors, .agent = 1}}).refused,
              HasSubstr("unknown robot: expected a number from 0 to 0, got 1"));
}

}  // namespace stop_conditions_test
}  // namespace robosim::run
