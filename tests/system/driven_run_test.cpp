// Tests that a run controlled step by step equals a run in which a script has the same actions.

#include "sim/launch/client/driven_run.h"

#include "sim/base/error.h"
#include "tests/support/require_target.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace driven_run_test {

using client::DrivenRun;
using result::Stop;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kS = 1000 * kMs;

client::Runner& runner(const std::string& target = "host") {
  static std::map<std::string, client::Runner> runners;
  return runners.try_emplace(target, target).first->second;
}

class OnEachTarget : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(DrivenRun, OnEachTarget, testing::Values("host", "avr"),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(OnEachTarget, GivesTheTraceOfTheSameLinesAsAScript) {
  const test::Run setup{.sketch = "AiNavigator", .map = "b", .goal = "none", .target = GetParam()};
  wire::RunRequest request = request_of(setup);
  request.script = "at 10ms cover S5 20ms";
  DrivenRun run(runner(GetParam()), request);
  ASSERT_TRUE(run.go_on(5 * kS, {Stop::serial("press the button")}));
  EXPECT_EQ(run.state().stop, 0);
  run.act("press start 100ms\npress bumper 3ms");
  ASSERT_TRUE(run.go_on(run.state().t_ns + 500 * kMs, {Stop::motors(true)}));
  EXPECT_EQ(run.state().stop, 0);
  ASSERT_TRUE(run.go_on(run.state().t_ns + 700 * kMs));
  run.act("place 6,10 E");
  ASSERT_TRUE(run.go_on(run.state().t_ns + 300 * kMs));
  const result::RunResult& driven = run.end();
  EXPECT_EQ(driven.verdict, "interrupted");

  request.script = run.script();
  request.for_ns = static_cast<std::int64_t>(driven.time_s * 1e9 + 0.5);
  EXPECT_EQ(runner(GetParam()).run(request).trace_hash, driven.trace_hash) << request.script;
}

TEST(DrivenRunTest, GivesTheTraceOfARunInOneGoWhereverItStandsStill) {
  const wire::RunRequest request =
      request_of({.sketch = "PidFollower", .map = "oval", .goal = "none", .for_s = 2.0});
  DrivenRun run(runner(), request);
  for (std::int64_t t = 0; run.go_on(t); t += 7 * kMs) {
  }
  EXPECT_EQ(run.result().trace_hash, runner().run(request).trace_hash);
}

TEST(DrivenRunTest, StandsStillAtTheStartAndTellsItsState) {
  DrivenRun run(runner(), request_of({.sketch = "PidFollower", .map = "a", .goal = "none"}));
  EXPECT_EQ(run.state().t_ns, 0);
  EXPECT_EQ(run.state().sample.x_mm, 450.0);
  EXPECT_EQ(run.state().sample.at_station, "1");
  EXPECT_FALSE(run.state().driven);
  ASSERT_TRUE(run.go_on(2 * kS));
  EXPECT_EQ(run.state().t_ns, 2 * kS);
  EXPECT_EQ(run.state().stop, -1);
  EXPECT_TRUE(run.state().driven);
  EXPECT_EQ(run.state().sample.at_station, "");
  EXPECT_THAT(run.state().metrics.stations, ElementsAre("1"));
  EXPECT_GT(run.state().worst.cross_track_mm, 1.0);
}

TEST(DrivenRunTest, StopsWhereItWasAskedTo) {
  DrivenRun run(runner(), request_of({.sketch = "AiNavigator", .map = "b", .goal = "none"}));
  ASSERT_TRUE(run.go_on(5 * kS, {Stop::line("^Put me .* scan\\.$")}));
  EXPECT_EQ(run.state().stop, 0);
  const std::size_t said = run.state().serial_bytes;
  run.act("press start 100ms");
  ASSERT_TRUE(run.go_on(20 * kS, {Stop::serial("Put me", said), Stop::at("2"), Stop::pin("D7", true)}));
  EXPECT_EQ(run.state().stop, 2) << "earlier text does not count; pins are watched inside a tick";
  ASSERT_TRUE(run.go_on(60 * kS, {Stop::visited("2")}));
  EXPECT_EQ(run.state().sample.at_station, "2");
  ASSERT_TRUE(run.go_on(90 * kS, {Stop::reading("LED2", true)})) << "LED2 is on at a station";
  EXPECT_EQ(run.state().stop, 0);
  ASSERT_TRUE(run.go_on(240 * kS, {Stop::rest(300 * kMs)}));
  EXPECT_EQ(run.state().stop, 0);
  EXPECT_FALSE(run.state().driven);
}

TEST(DrivenRunTest, TellsTheFirmwaresMemory) {
  DrivenRun run(runner(), request_of({.sketch = "PidFollower", .goal = "none"}));
  EXPECT_EQ(run.eeprom(), std::vector<std::uint8_t>(1024, 0xFF)) << "erased, as from the factory";
}

TEST(DrivenRunTest, GoesOnAfterWhatMakesNoSense) {
  DrivenRun run(runner(), request_of({.sketch = "PidFollower", .goal = "none"}));
  const auto refusal = [&](const auto& deed) -> std::string {
    try {
      deed();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal([&] { run.act("press nothing"); }), AllOf(HasSubstr("nothing"), HasSubstr("start")));
  EXPECT_THAT(refusal([&] { run.act("press start\njump"); }), HasSubstr("unknown verb"));
  EXPECT_THAT(refusal([&] { run.go_on(kS, {Stop::visited("9")}); }), HasSubstr("unknown station 9"));
  EXPECT_THAT(refusal([&] { run.go_on(kS, {Stop::line("(")}); }), HasSubstr("regular expression"));
  EXPECT_THAT(refusal([&] { run.go_on(kS, {Stop::pin("D99", true)}); }), HasSubstr("no pin D99"));
  EXPECT_THAT(refusal([&] { run.go_on(kS, {Stop::reading("lamp", true)}); }), HasSubstr("got “lamp”"));
  EXPECT_EQ(run.script(), "");
  EXPECT_TRUE(run.go_on(kS));
}

TEST(DrivenRunTest, EndsWithTheVerdictAndLeavesTheRunnerToOthers) {
  wire::RunRequest request = request_of({.sketch = "HangsDriving", .goal = "none"});
  DrivenRun run(runner(), request);
  EXPECT_FALSE(run.go_on(600 * kS));
  EXPECT_EQ(run.result().verdict, "hung");
  EXPECT_FALSE(run.go_on(700 * kS));
  { DrivenRun unfinished(runner(), request); }
  EXPECT_EQ(runner().run(request).verdict, "hung");
}

TEST(DrivenRunTest, EndsWithTheVerdictCrashedWhereTheFirmwareTakesItsProcessDown) {
  DrivenRun run(runner(), request_of({.sketch = "OverrunsHeap", .goal = "none"}));
  EXPECT_FALSE(run.go_on(10 * kS));
  EXPECT_EQ(run.result().verdict, "crashed");
  EXPECT_EQ(run.state().t_ns, 0);
}

}  // namespace driven_run_test
}  // namespace robosim::test
