// Tests scripts that change the world while the built-in driver follows the oval.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/support/built_in_driver.h"
#include "tests/support/event_values.h"
#include "tests/support/one_robot.h"
#include "tests/support/refusal.h"

namespace robosim::scenario::world_changes_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class ChangingWorld : public testing::Test, public run::Listener {
 protected:
  judge::Outcome play(const std::string& script, double seconds) {
    test::BuiltInDriver driver;
    test::OneRobot one(driver, "none", script);
    one.setup.map = &map;
    one.setup.agents[0].listener = this;
    one.setup.samples_every = kTick;
    one.setup.profile = profile;
    one.setup.seed = seed;
    samples.clear();
    happenings.clear();
    values.clear();
    volts.clear();
    return one.run(static_cast<SimTime>(seconds * 1e9));
  }
  std::string error_of(const std::string& script) {
    return test::refusal([&] { play(script, 0.01); }, "no error");
  }
  void sampled(const run::Sample& sample) override { samples.push_back(sample); }
  bool wants_inputs() const override { return true; }
  void volts_seen(Pin pin, double seen, SimTime) override { volts[pin].push_back(seen); }
  void happened(const result::RunEvent& event) override {
    happenings.push_back(result::text_of(event));
    values.push_back(test::values_of(event));
  }
  const run::Sample& at(double seconds) const {
    return samples[static_cast<std::size_t>(seconds * 1000.0 + 0.5)];
  }
  Vec2 place(double seconds) const { return at(seconds).pose.position; }

  map::Map map = map::read_map(map::find_map("oval"));
  Profile profile = Profile::ideal;
  std::uint64_t seed = 1;
  std::vector<run::Sample> samples;  // one per millisecond
  std::vector<std::string> happenings, values;
  std::map<Pin, std::vector<double>> volts;  // read by the firmware every 5 ms
};

TEST_F(ChangingWorld, ASensorThatStandsStillSeesTheLineGoAndCome) {
  play(
      "at 0ms fault left dead\nat 0ms fault right dead\nat 300ms erase 3,14 20,14\nat 600ms paint 3,14 "
      "20,14\n",
      0.9);
  EXPECT_EQ(place(0.0), place(0.9 - 0.001));
  const std::vector<double>& middle = volts[16];  // A2
  const auto seen = [&](double seconds) { return middle.at(static_cast<std::size_t>(seconds / 0.005)); };
  EXPECT_GT(seen(0.2), 4.0);
  EXPECT_LT(seen(0.5), 1.0);
  EXPECT_GT(seen(0.8), 4.0);
}

TEST_F(ChangingWorld, ItsChangesAreToldWithTheirPlaces) {
  play(
      "at 1ms door 2,3 2,5 shut for 2ms\nat 1ms obstacle 0,16 to 3,16 in 2s\n"
      "at 2ms paint 1,1 4,1\nat 2ms erase 1,2 4,2 for 2ms\n",
      0.01);
  EXPECT_THAT(values, testing::IsSupersetOf(
                          {"1 script_acted verb=door part=shut argument=2,3 2,5 box=240,1140,20,220",
                           "3 script_acted verb=restore part=open argument=2,3 2,5 box=240,1140,20,220",
                           "1 script_acted verb=obstacle argument=0,16 disc=50,50,33 moves=350,50,2",
                           "2 script_acted verb=paint argument=1,1 4,1 box=140,1540,320,20",
                           "2 script_acted verb=erase argument=1,2 4,2 box=135,1435,330,30",
                           "4 script_acted verb=restore argument=1,2 4,2 box=135,1435,330,30"}));
}

TEST_F(ChangingWorld, EachSeedDrawsWhenAndWhereWithinTheSpreadAndIdealNothing) {
  const std::string script = "at 5ms+-3ms obstacle 3+-1,16\n";
  std::set<std::string> told;
  const auto play_it = [&](const std::string& text) {
    play(text, 0.01);
    return values.at(0);
  };
  EXPECT_EQ(play_it(script), "5 script_acted verb=obstacle argument=3,16 disc=350,50,33");
  profile = Profile::typical;
  for (seed = 1; seed <= 20; ++seed) {
    told.insert(play_it(script));
    EXPECT_EQ(play_it("# a line above\n" + script), play_it(script)) << "equal seeds draw equal values";
  }
  EXPECT_GT(told.size(), 8u);
  for (const std::string& one : told)
    EXPECT_THAT(one, testing::MatchesRegex("[2-8] script_acted verb=obstacle argument=[234],16 .*"));
  EXPECT_THAT(error_of("at 5ms obstacle 24+-1,3"), HasSubstr("25,3"))
      << "this error does not depend on the seed";
}

TEST_F(ChangingWorld, ALineThatIsErasedIsNoLongerSeen) {
  play("", 1.0);
  EXPECT_GT(at(0.5).readings[2], 0.9) << "the middle sensor is on the line";
  play("at 300ms erase 3,14 20,14 for 20ms\n", 1.0);
  EXPECT_GT(at(0.299).readings[2], 0.9);
  EXPECT_EQ(at(0.310).readings[2], 0.0);
  EXPECT_GT(at(0.321).readings[2], 0.9) << "the line is back";
  EXPECT_THAT(happenings, ElementsAre("line erased, 3,14 to 20,14", "floor restored, 3,14 to 20,14"));
}

TEST_F(ChangingWorld, ALineThatIsErasedCountsAsNone) {
  EXPECT_EQ(play("", 1.0).metrics.off_line_s, 0.0);
  EXPECT_GT(play("at 300ms erase 3,14 20,14\n", 1.0).metrics.off_line_s, 0.2);
}

TEST_F(ChangingWorld, ALineThatIsPaintedIsSeenBesideTheMapsOwn) {
  // The script paints a line in the middle of the field, and places the robot on it.
  play("at 10ms lift\nat 20ms paint 4,8 20,8\nat 30ms place 10,14,E\nat 40ms place 650mm,850mm,E\n", 0.1);
  const map::Map& m = map;
  EXPECT_NEAR(m.centre({10, 8}).y, 0.1 * (m.height - 8.5), 1e-9);
  EXPECT_GT(at(0.09).readings[2], 0.9) << "in the middle of the field, where the map has no line";
}

TEST_F(ChangingWorld, AShutDoorStopsTheRobotUntilItOpens) {
  const judge::Outcome outcome = play("at 0s door 15,13 15,15 shut for 3s\n", 6.0);
  EXPECT_EQ(outcome.metrics.collisions, 1);
  EXPECT_LT(length(place(2.9) - place(2.0)), 0.05) << "the robot is stopped by the door";
  EXPECT_GT(length(place(5.0) - place(3.0)), 0.3);
  EXPECT_THAT(happenings, Contains("door shut, 15,13 to 15,15"));
  EXPECT_THAT(happenings, Contains("door open, 15,13 to 15,15"));
}

TEST_F(ChangingWorld, AnObstacleThatMovesPushesTheRobotThatStandsInItsWay) {
  play("at 0s fault left dead\nat 0s fault right dead\nat 100ms obstacle 4,14 radius 50mm to 20,14 in 4s\n",
       6.0);
  const Vec2 before = place(0.1);
  EXPECT_EQ(place(0.5).x, before.x);
  EXPECT_GT(length(place(4.5) - before), 0.05) << "the obstacle pushed the robot";
  EXPECT_LT(length(place(6.0) - place(4.5)), 0.01) << "the obstacle has stopped";
}

TEST_F(ChangingWorld, LightsGoOffAndOn) {
  map.lights.push_back({.level = 0.5});
  play("at 0s power off\nat 100ms light 1 off for 100ms\nat 300ms light all off\nat 400ms light all on\n",
       0.5);
  const auto seen = [&](double seconds) { return at(seconds).readings[0]; };
  EXPECT_NEAR(seen(0.05), seen(0.25), 1e-9);
  EXPECT_NEAR(seen(0.15), seen(0.35), 1e-9);
  EXPECT_THAT(happenings,
              ElementsAre("power off", "light 1 off", "light 1 on", "all lights off", "all lights on"));
}

struct Bad {
  const char* line;
  const char* said;
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.line; }

class BadChange : public ChangingWorld, public testing::WithParamInterface<Bad> {};

TEST_P(BadChange, IsOneSentenceWithItsPlace) {
  const std::string error = error_of(GetParam().line);
  EXPECT_THAT(error, testing::StartsWith("s.txt:1"));
  EXPECT_THAT(error, HasSubstr(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, BadChange,
    testing::Values(Bad{"at 1s paint", "expected the cell where it begins, as X,Y"},
                    Bad{"at 1s paint 4,4", "expected the cell where it ends, as X,Y"},
                    Bad{"at 1s paint 4,4 5,5", "expected two in one row or one column, got 4,4 and 5,5"},
                    Bad{"at 1s paint 4,4 4,99", "invalid cell"}, Bad{"at 1s paint red 4,9", "invalid cell"},
                    Bad{"at 1s paint 4,4 4,9 for ever", "got \"ever\""},
                    Bad{"at 1s erase 4,4 4,9 now", "got \"now\""},
                    Bad{"at 1s erase 4,4 4,9 2s 3s", "unexpected \"3s\""},
                    Bad{"at 1s door 4,4 4,9", "the line ends too early: expected shut or open"},
                    Bad{"at 1s door 4,4 4,9 ajar", "a door: expected shut or open, got “ajar”"},
                    Bad{"at 1s door 4,4 9,9 shut", "in one row or one column"},
                    Bad{"at 1s door 4,4 shut", "the line ends too early: expected shut or open"},
                    Bad{"at 1s door 4,4 4,4 shut", "invalid door: expected two different cells"},
                    Bad{"at 1s light", "expected a light's number, or all"},
                    Bad{"at 1s light all", "the line ends too early: expected on or off"},
                    Bad{"at 1s light 1 dim", "a light: expected on or off, got “dim”"},
                    Bad{"at 1s light 1 off", "the map has no light to switch"},
                    Bad{"at 1s obstacle 4,4 to", "expected the cell that it moves to, as X,Y"},
                    Bad{"at 1s obstacle 4,4 to 5,5",
                        "the duration of the move is missing: expected `to X,Y in TIME`"},
                    Bad{"at 1s obstacle 4,4 to 5,5 in", "expected a time such as 2s or 100ms"},
                    Bad{"at 1s obstacle 4,4 to 5,5 in 10us", "the move is too fast: expected at least 1ms"},
                    Bad{"at 1s obstacle 4,4 to 99,5 in 1s", "invalid cell"}));

TEST_F(ChangingWorld, HasALimit) {
  std::string script;
  for (int i = 0; i <= 100; ++i) script += "at 1s paint 4,4 4,9\n";
  EXPECT_THAT(error_of(script),
              HasSubstr("s.txt:101: the script is too long: expected at most 100 lines that paint"));
}

}  // namespace robosim::scenario::world_changes_test
