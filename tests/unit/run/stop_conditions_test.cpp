// Tests the conditions that end a step, in runs that a StepController advances step by step.

#include <gmock/gmock.h>

#include "tests/support/built_in_driver.h"
#include "tests/support/one_robot.h"

namespace robosim::run::stop_conditions_test {

using testing::HasSubstr;

/// The built-in driver, which also sends `text`: one byte per millisecond from the start of the run.
class Talker final : public test::BuiltInDriver {
 public:
  explicit Talker(std::string text) : text_(std::move(text)) {}
  SimTime sleeps_until() const override { return 0; }
  void run_until(SimTime t) override {
    if (said_ < text_.size()) board_.send_byte(text_[said_++], t - kTick);
    BuiltInDriver::run_until(t);
  }

 private:
  std::string text_;
  std::size_t said_ = 0;
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
    Talker talker(says);
    OneLeg controller;
    controller.leg = {.until = until, .stops = std::move(stops)};
    test::OneRobot one(talker, "none", script);
    one.setup.controller = &controller;
    one.run(10 * kSecond);
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

}  // namespace robosim::run::stop_conditions_test
