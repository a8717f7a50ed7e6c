// Tests how `robosim hunt` draws test cases, and how it compares the output of two runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "sim/campaign/hunt/differential_testing.h"
#include "sim/campaign/hunt/input_dictionary.h"
#include "sim/campaign/hunt/oracle.h"
#include "sim/campaign/hunt/stimuli.h"

namespace robosim::campaign {
namespace hunt_differential_test {

using ::testing::HasSubstr;

result::RunResult sent(const std::string& serial, double distance_m = 0.0) {
  result::RunResult result;
  result.serial = serial;
  result.metrics.distance_m = distance_m;
  return result;
}

std::string apart(const result::RunResult& ours, const result::RunResult& other, bool numbers = true) {
  const auto found = divergence(ours, other, numbers);
  return found ? found->ours + "; " + found->other : "";
}

HuntSpace space_of_a_talker() {
  HuntSpace space;
  space.builds = {{"avr", false}, {"avr", true}, {"host", true}, {"host", false}};
  space.host_counterpart = 3;
  space.maps.emplace_back().name = "oval";
  space.words = {"go", "1"};
  space.said = {"destination?"};
  return space;
}

TEST(HuntTwin, PartsWhereAnotherLineIsSaid) {
  EXPECT_EQ(apart(sent("ready\r\nok\r\n"), sent("ready\r\nunknown\r\n")), "says “ok”; says “unknown”");
  EXPECT_EQ(apart(sent("ready\n"), sent("ready\ngoing\n")), "prints nothing at that point; says “going”");
  EXPECT_EQ(apart(sent("ready\nok\n"), sent("ready\nok\nbe")), "");  // the next line may still be arriving
}

TEST(HuntTwin, PartsWhereANumberIsFarFromTheOther) {
  EXPECT_EQ(apart(sent("way 3 mm\n"), sent("way 200 mm\n")), "says “way 3 mm”; says “way 200 mm”");
  EXPECT_EQ(apart(sent("way -200\n"), sent("way 200\n")), "says “way -200”; says “way 200”");
  EXPECT_EQ(apart(sent("way 190 mm in 12 s\n"), sent("way 200 mm in 30 s\n")), "");
  EXPECT_EQ(apart(sent("ms 17\n"), sent("ms 70000\n"), false), "");
}

TEST(HuntTwin, LooksAtLinesThatComeOftenByThemselves) {
  std::string ours, other;
  for (int i = 0; i < 30; ++i) ours += "tick\nat 200 mm\n", other += "tick\ntick\nat 201 mm\n";
  EXPECT_EQ(apart(sent(ours), sent(other)), "");
  EXPECT_EQ(apart(sent(ours), sent("at 2 mm\n" + other)), "says “at 200 mm”; says “at 2 mm”");
}

TEST(HuntTwin, CountsLinesWhereTheClockAloneIsAnother) {
  std::string many;
  for (int i = 0; i < 60; ++i) many += "bump\n";
  const std::string few = "bump\nbump\nbump\n";
  EXPECT_EQ(apart(sent(many), sent(few), false), "says “bump” 60 times; says “bump” 3 times");
  EXPECT_EQ(apart(sent(many), sent(few), true), "") << "one of two targets may be slower";
  EXPECT_EQ(apart(sent(many), sent(many + few), false), "");
}

TEST(HuntTwin, WrapsTheClockOfWhoStandsBeforeSomething) {
  HuntSpace space = space_of_a_talker();
  space.feels = true;
  space.maps.front().line = {{3, 4}};
  int blocked = 0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    if (test_case.differential == Differential::clock &&
        script_text(test_case, space) == "at 200ms obstacle 3,4 for 60s\n")
      ++blocked;
  }
  EXPECT_GT(blocked, 4);
}

TEST(HuntTwin, PressesAroundWhere16BitsDoNotHoldTheMillisecondsAndRunsOn) {
  HuntSpace space = space_of_a_talker();
  space.words.clear();
  space.buttons = {"start"};
  int late = 0;
  for (std::uint64_t run = 5; run < 600; run += 6) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    if (test_case.stimuli.empty()) continue;
    ++late;
    ASSERT_EQ(test_case.differential, Differential::host);
    ASSERT_EQ(test_case.stimuli.size(), 3U);
    EXPECT_LT(test_case.stimuli[0].at_ms, 65'536);
    EXPECT_GT(test_case.stimuli[1].at_ms, 65'536);
    EXPECT_GT(test_case.stimuli[2].at_ms, test_case.stimuli[1].at_ms);
    EXPECT_GT(span_ms(test_case, space), test_case.stimuli[2].at_ms);
  }
  EXPECT_GT(late, 25);
  EXPECT_LT(late, 60);
}

TEST(HuntTwin, SpeaksTheSketchsOwnWordsAsOftenAsAllOthers) {
  HuntSpace space = space_of_a_talker();
  space.words.assign(40, "9");
  space.words.emplace_back("calibrate");
  space.own_words = 1;
  int own = 0, all = 0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    for (const Stimulus& stimulus : test_case.stimuli) {
      if (stimulus.kind != "send") continue;
      ++all;
      own += stimulus.what.starts_with("send \"calibrate");
    }
  }
  EXPECT_GT(10 * own, 3 * all);
  EXPECT_LT(10 * own, 7 * all);
}

TEST(TestCase, HoldsAButtonAtPowerOnWaitsAndTakesUsedBoards) {
  HuntSpace space = space_of_a_talker();
  space.buttons = {"start"};
  space.opening = {{1000, "press start 100ms", "press start"}};
  space.uses_eeprom = true;
  int held = 0, later = 0, used = 0;
  for (std::uint64_t run = 0; run < 400; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    const std::string script = script_text(test_case, space);
    const bool holds = script.find("at 0ms press start ") != std::string::npos;
    if (holds) {
      EXPECT_GE(opening_of(test_case, space).front().at_ms, 4000);
    }
    held += holds;
    later += test_case.later_ms > 0;
    used += script.starts_with("at 0ms fault eeprom used\n");
    EXPECT_EQ(needs_of(test_case, space).contains("a longer wait before the start"), test_case.later_ms > 0);
  }
  EXPECT_GT(held, 8);
  EXPECT_GT(later, held);
  EXPECT_GT(used, 40);
}

TEST(TestCase, GoesAtOnceInASmallerWorld) {
  HuntSpace space = space_of_a_talker();
  space.opening = {{1000, "press start 100ms", "press start"}};
  TestCase test_case;
  test_case.later_ms = 5000;
  test_case.stimuli = {{2000, "lift for 300ms", "lift"}, {6000, "press start 100ms", "press start"}};
  bool found = false;
  for (const TestCase& next : smaller(test_case, space))
    found |= next.later_ms == 0 &&
             next.stimuli == std::vector<Stimulus>{{2000, "lift for 300ms", "lift"},
                                                   {1000, "press start 100ms", "press start"}};
  EXPECT_TRUE(found);
}

TEST(TestCase, IsTheHostsAsOftenAsAllOthers) {
  HuntSpace space = space_of_a_talker();
  int host = 0, chip = 0, checked = 0;
  for (std::uint64_t run = 0; run < 400; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    if (test_case.differential != Differential::none) continue;
    host += test_case.build == 3, chip += test_case.build == 0,
        checked += space.builds[test_case.build].checked;
  }
  EXPECT_NEAR(host, 183, 30);
  EXPECT_GT(chip, 60);
  EXPECT_GT(checked, 30);
}

TEST(TestCase, BranchesOffWhereSomethingNewWasSeen) {
  HuntSpace space = space_of_a_talker();
  space.buttons = {"start"};
  Noted at, behind;
  at.test_case.seed = 4711;
  at.moment.at_ms = 30000;
  behind.test_case.seed = 4712;
  behind.moment.after = "found ";
  int branches = 0, talks = 0;
  for (std::uint64_t run = 0; run < 400; ++run) {
    const TestCase test_case = draw_round(space, {at, behind}, 1, {run}).front();
    if (test_case.seed != 4711 && test_case.seed != 4712) continue;
    ASSERT_EQ(test_case.stimuli.size(), 1U);
    const Stimulus& stimulus = test_case.stimuli.front();
    ++(test_case.seed == 4711 ? branches : talks);
    EXPECT_EQ(stimulus.after, test_case.seed == 4711 ? "" : "found ");
    const int from_ms = test_case.seed == 4711 ? 30000 : 0;
    EXPECT_GE(stimulus.at_ms, from_ms + 10);
    EXPECT_LT(stimulus.at_ms, from_ms + 2010);
  }
  EXPECT_GT(branches, 10);
  EXPECT_GT(talks, 10);
}

TEST(TestCase, OfAFamilyGoOnOnAChipFromOneMoment) {
  HuntSpace space = space_of_a_talker();
  space.buttons = {"start"};
  Noted at;
  at.test_case.stimuli = {{1000, "press start 100ms", "press start"}, {40000, "lift for 1s", "lift"}};
  at.moment.at_ms = 30000;
  std::vector<std::uint64_t> runs(kRound);
  std::iota(runs.begin(), runs.end(), 24);
  const std::vector<TestCase> test_cases = draw_round(space, {at}, 1, runs);
  ASSERT_EQ(test_cases.size(), kRound);
  std::set<std::string> last;
  for (std::size_t i = 0; i < kRound; ++i) {
    const TestCase& test_case = test_cases[i];
    EXPECT_EQ(test_case.family > 0, i >= kRound - kFamily) << i;
    if (test_case.family == 0) continue;
    EXPECT_EQ(test_case.family, test_cases.back().family);
    EXPECT_NE(space.builds[test_case.build].target, "host");
    EXPECT_EQ(test_case.branch_point.at_ms, 30000);
    // The test case equals `at.test_case` until 30 s. Its new stimulus is the last in the list, although the
    // second stimulus takes effect later, at 40 s.
    ASSERT_EQ(test_case.stimuli.size(), 3U);
    EXPECT_TRUE(
        std::equal(at.test_case.stimuli.begin(), at.test_case.stimuli.end(), test_case.stimuli.begin()));
    EXPECT_GE(test_case.stimuli.back().at_ms, 30010);
    EXPECT_LT(test_case.stimuli.back().at_ms, 32010);
    last.insert(script_text(test_case, space));
  }
  EXPECT_GT(last.size(), 1U);
  runs.pop_back();
  for (const TestCase& test_case : draw_round(space, {at}, 1, runs)) EXPECT_EQ(test_case.family, 0U);
}

TEST(HuntSymptom, HasTheMomentOfTheFirstNewEventOrLine) {
  result::RunResult result = sent("ready\r\nfound station 2\r\n");
  result.events = {
      {0.5, "\"go: 1\\n\" sent to the sketch"}, {1.0, "start pressed"}, {2.5, "station 2 visited"}};
  EXPECT_THAT(traits_of(result), testing::Not(testing::Contains(HasSubstr("start pressed"))));
  EXPECT_THAT(traits_of(result), testing::Not(testing::Contains(HasSubstr("go"))));
  EXPECT_EQ(moment_of({"serial found station #\r", "event station # visited"}, result).at_ms, 2500);
  EXPECT_EQ(moment_of({"serial found station #\r"}, result).after, "found station ");
  EXPECT_FALSE(moment_of({"verdict lost", "ran Line.ino:3"}, result).is_known());
}

TEST(TestCase, PutsNoObstacleBesideTheLineOfASmallerMap) {
  HuntSpace space = space_of_a_talker();
  space.maps.front().line = {{3, 4}};
  TestCase test_case;
  test_case.track = random_worlds::lay_out({3, 4, 0}, [](int below) { return below / 2; });
  test_case.stimuli = {{200, "obstacle 3,4 for 60s", kObstacle}, {200, "obstacle 30,40 for 60s", kObstacle}};
  const TestCase next = smaller(test_case, space).front();
  EXPECT_FALSE(next.drawn());
  ASSERT_EQ(next.stimuli.size(), 1U);
  EXPECT_EQ(next.stimuli.front().what, "obstacle 3,4 for 60s");
}

TEST(HuntSymptom, IsWhatTheCompilerWarnsOfOnceForEachLine) {
  const auto warned = warned_in(
      "Line.ino: In function 'void loop()':\n"
      "Line.ino:4:9: warning: suggest parentheses around assignment used as truth value [-Wparentheses]\n"
      "   if (x = 1) f();\n"
      "Line.ino:4:9: warning: suggest parentheses around assignment used as truth value [-Wparentheses]\n"
      "Line.ino:7:3: warning: 'f' is deprecated [-Wdeprecated-declarations]\n"
      "Line.ino:9:3: warning: 'inverted' may be used uninitialized [-Wmaybe-uninitialized]\n");
  ASSERT_EQ(warned.size(), 2U);
  EXPECT_EQ(warned[1].sentence, "The compiler warns: 'inverted' may be used uninitialized, Line.ino:9.");
  EXPECT_EQ(warned[0].sentence,
            "The compiler warns: suggest parentheses around assignment used as truth value, Line.ino:4.");
}

TEST(HuntWords, AreOfSketchesThatReadAStreamAndNotOnlyTheEeprom) {
  EXPECT_TRUE(reads_input("if (bluetooth.available()) c = bluetooth.read();"));
  EXPECT_TRUE(reads_input("x = EEPROM.read(0); c = Serial.read();"));
  EXPECT_FALSE(reads_input("x = EEPROM.read(0); y = EEPROM.read(1);"));
  std::vector<std::string> words;
  add_words("#include \"Go.h\"\nif (c == 'g' || s == \"stop\") Serial.print(F(\"gone\"));", words);
  EXPECT_EQ(words, (std::vector<std::string>{"g", "stop"}));
}

TEST(HuntDeeds, BeginBehindLinesOfTheSketchTheLastOfThemLast) {
  EXPECT_EQ(beginnings_of("destination?\r\nfound station 2\r\nfound station 3\r\ndestination?\r\n"),
            (std::vector<std::string>{"found station ", "destination?"}));
  EXPECT_TRUE(beginnings_of("").empty());
  EXPECT_EQ(beginnings_of("ready"), std::vector<std::string>{"ready"});
}

TEST(HuntDeeds, TwistARobotSoFarThatItHasToLookForItsLine) {
  HuntSpace space = space_of_a_talker();
  space.parts.motors = {"left"};
  int far = 0;
  for (std::uint64_t run = 0; run < 500; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    for (const Stimulus& stimulus : test_case.stimuli) {
      if (stimulus.kind != kTwisted) continue;
      const int ms = std::stoi(stimulus.what.substr(stimulus.what.rfind(' ') + 1));
      EXPECT_GE(ms, 200);
      EXPECT_LT(ms, 800);
      if (ms > 500) ++far;
    }
  }
  EXPECT_GT(far, 2);
}

TEST(HuntSymptom, IsNotHowARobotBehavesWhoseWheelWasHeld) {
  const HuntSpace space = space_of_a_talker();
  TestCase test_case;
  test_case.stimuli = {{2000, "fault left stuck for 500ms", kHeld}};
  EXPECT_FALSE(tells_behaviour(test_case, space));
  test_case.stimuli.clear();
  EXPECT_TRUE(tells_behaviour(test_case, space));
}

TEST(HuntSymptom, IsNotHowARobotBehavesOnNetworksWhichItIsNotFor) {
  HuntSpace space = space_of_a_talker();
  space.maps.front().tours = false;
  TestCase test_case;
  EXPECT_TRUE(tells_behaviour(test_case, space));
  test_case.network.emplace();
  EXPECT_FALSE(tells_behaviour(test_case, space));
  space.maps.front().tours = true;
  EXPECT_TRUE(tells_behaviour(test_case, space));
}

TEST(HuntTwin, PartsWhereOnlyOneDrives) {
  EXPECT_EQ(apart(sent("", 4.0), sent("", 0.0)), "drives; stands");
  EXPECT_EQ(apart(sent("", 4.0), sent("", 1.0)), "");
}

TEST(HuntTwin, TakesNumbersThatAreOthersEachTimeForChance) {
  const Divergence first = *divergence(sent("a 5\n"), sent("a 500\n"), true);
  EXPECT_TRUE(is_same(first, *divergence(sent("a 5\n"), sent("a 510\n"), true)));
  EXPECT_TRUE(is_same(*divergence(sent("a 5 in 6744 us\n"), sent("a 500 in 6828 us\n"), true),
                      *divergence(sent("a 5 in 5668 us\n"), sent("a 500 in 4740 us\n"), true)));
  EXPECT_FALSE(is_same(first, *divergence(sent("a 500\n"), sent("a 5\n"), true)));
  EXPECT_FALSE(is_same(first, *divergence(sent("b 5\n"), sent("b 500\n"), true)));
}

TEST(HuntTwin, IsTheSameWorldOnTheHostOrWithoutTheClock) {
  const HuntSpace space = space_of_a_talker();
  bool host = false, clock = false, talks = false;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const TestCase test_case = draw_round(space, {}, 1, {run}).front();
    if (test_case.differential == Differential::none) continue;
    EXPECT_NE(test_case.build, *space.host_counterpart) << run;
    for (const Stimulus& stimulus : test_case.stimuli)
      EXPECT_FALSE(test_case.differential == Differential::host && stimulus.kind == kPowerOff)
          << "a power cut would split the two texts at different bytes";
    const TestCase differential = counterpart_of(test_case, space);
    if (test_case.differential == Differential::clock) {
      // The counterpart's clock starts earlier than the test case's clock, and therefore does not wrap. It
      // starts at kPast_ms or later, because by that time a sketch has finished its one-time actions.
      EXPECT_GE(differential.clock_ms, kPast_ms);
      EXPECT_LT(differential.clock_ms, test_case.clock_ms);
      EXPECT_TRUE(differential.clock_ms == kPast_ms ||
                  (test_case.clock_ms - differential.clock_ms) % (1 << 16) == 0);
    } else {
      EXPECT_EQ(differential.clock_ms, 0);
    }
    EXPECT_EQ(differential.build, test_case.differential == Differential::host ? 3U : 0U);
    EXPECT_EQ(differential.stimuli, test_case.stimuli);
    EXPECT_EQ(test_case.clock_ms != 0, test_case.differential == Differential::clock);
    (test_case.differential == Differential::host ? host : clock) = true;
    talks |= script_text(test_case, space).find("after serial \"destination?\" wait 200ms send ") == 0;
  }
  EXPECT_TRUE(host && clock && talks);
}

TEST(HuntTwin, IsToldInOneSentence) {
  const HuntSpace space = space_of_a_talker();
  TestCase test_case;
  test_case.differential = Differential::host;
  EXPECT_EQ(symptom_of({"says “3”", "says “200”", "#", {3}, {200}}, test_case, space).sentence,
            "The host says “200”, but the avr says “3”; noise is not the reason.");
  test_case.differential = Differential::clock;
  EXPECT_THAT(symptom_of({"stands", "drives", "", {}, {}}, test_case, space).sentence,
              HasSubstr("some minutes earlier it drives"));
}

}  // namespace hunt_differential_test
}  // namespace robosim::campaign
