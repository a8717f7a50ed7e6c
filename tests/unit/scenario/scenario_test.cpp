#include "sim/run/scenario/scenario.h"
#include "tests/support/refusal.h"

#include <gmock/gmock.h>

namespace robosim::scenario::scenario_test {

std::string error_of(const char* text) {
  return test::refusal([&] { parse_scenario(text, "s.txt"); }, "no error");
}

TEST(Scenario, ReadsTriggersVerbsTextsAndComments) {
  const auto steps = parse_scenario(
      "# a comment\n"
      "at 2s press start 100ms\n"
      "\n"
      "after serial \"Ready # 1\" send \"3\\n\"   # answer\r\n"
      "after station dock place 2,2,E\n"
      "at 5s fault S2 stuck 1023",
      "s.txt");
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[0].trigger.time, 2 * kSecond);
  EXPECT_EQ(steps[0].action.part, "start");
  EXPECT_EQ(*steps[0].action.duration, 100 * kMillisecond);
  EXPECT_EQ(steps[1].trigger.kind, Trigger::Kind::serial);
  EXPECT_EQ(steps[1].trigger.text, "Ready # 1");
  EXPECT_EQ(steps[1].action.text, "3\n");
  EXPECT_EQ(steps[2].trigger.text, "dock");
  EXPECT_EQ(steps[2].action.text, "2,2,E");
  EXPECT_EQ(steps[3].action.arguments, (std::vector<std::string>{"stuck", "1023"}));
  EXPECT_EQ(to_string(steps[3].place), "s.txt:6");
}

TEST(Scenario, TakesThePlaceWithASpaceBeforeTheDirection) {
  EXPECT_EQ(parse_scenario("at 0s place 2,2 E", "s.txt")[0].action.text, "2,2,E");
}

TEST(Scenario, SendsTextToTheSketchAndMessagesToParts) {
  const auto steps = parse_scenario(
      "at 1s send \"3\\n\"\n"
      "at 2s send hello\n"
      "at 3s send radio 3\n"
      "at 4s send radio 0b101\n"
      "at 5s send bt \"go\\n\"\n"
      "at 6s send ir 0x45 for 500ms\n",
      "s.txt");
  EXPECT_EQ(steps[0].action.part, "");
  EXPECT_EQ(steps[0].action.text, "3\n");
  EXPECT_EQ(steps[1].action.text, "hello");
  EXPECT_EQ(steps[2].action.part, "radio");
  EXPECT_EQ(steps[2].action.text, "3");
  EXPECT_EQ(steps[3].action.text, "0b101");
  EXPECT_EQ(steps[4].action.part, "bt");
  EXPECT_EQ(steps[4].action.text, "go\n");
  EXPECT_EQ(steps[5].action.text, "0x45");
  EXPECT_EQ(steps[5].action.held, 500 * kMillisecond);
}

TEST(Scenario, WaitsForWhatAPartTells) {
  const auto steps = parse_scenario("after bt \"ready\" send bt \"go\"\n", "s.txt");
  EXPECT_EQ(steps[0].trigger.kind, Trigger::Kind::told);
  EXPECT_EQ(steps[0].trigger.part, "bt");
  EXPECT_EQ(steps[0].trigger.text, "ready");
}

TEST(Scenario, WaitsAfterAnEvent) {
  const auto steps = parse_scenario(
      "after serial \"go\" wait 200ms press b 1s\n"
      "after station 3 wait 1.5s lift for 2s\n"
      "after station 3 lower\n",
      "s.txt");
  EXPECT_EQ(steps[0].trigger.time, 200 * kMillisecond);
  EXPECT_EQ(*steps[0].action.duration, kSecond);
  EXPECT_EQ(steps[1].trigger.time, 1500 * kMillisecond);
  EXPECT_EQ(*steps[1].action.duration, 2 * kSecond);
  EXPECT_EQ(steps[2].trigger.time, 0);
  EXPECT_EQ(steps[2].action.verb, Action::Verb::lower);
}

TEST(Scenario, EndsWhatLastsAfterItsTimeWithTheWordForOrWithout) {
  const auto steps = parse_scenario(
      "at 1s fault S2 stuck 1023 for 500ms\n"
      "at 1s fault left dead\n"
      "at 1s cover S for 3s\n"
      "at 1s press b 1ms\n"
      "at 1s power off for 20ms\n"
      "at 1s obstacle 4,2 radius 5cm for 1min\n"
      "at 1s obstacle 4,2\n",
      "s.txt");
  EXPECT_EQ(steps[0].action.arguments, (std::vector<std::string>{"stuck", "1023"}));
  EXPECT_EQ(*steps[0].action.duration, 500 * kMillisecond);
  EXPECT_FALSE(steps[1].action.duration);
  EXPECT_EQ(*steps[2].action.duration, 3 * kSecond);
  EXPECT_EQ(*steps[3].action.duration, kMillisecond);
  EXPECT_EQ(*steps[4].action.duration, 20 * kMillisecond);
  EXPECT_EQ(steps[5].action.radius, 0.05);
  EXPECT_EQ(*steps[5].action.duration, 60 * kSecond);
  EXPECT_EQ(steps[6].action.text, "4,2");
  EXPECT_EQ(steps[6].action.radius, kObstacleRadius);
  EXPECT_FALSE(steps[6].action.duration);
}

TEST(Scenario, RefusesWhatLastsForLessThanATickWithOrWithoutASpread) {
  for (const char* line : {"at 1s lift for 0s", "at 1s press b 999us", "at 1s power off for 1s+-1s",
                           "at 1s door 1,1 1,5 shut for 0s", "at 1s fault S2 stuck 1023 for 0s"}) {
    EXPECT_THAT(test::refusal([&] { parse_scenario(line, "s.txt"); }),
                testing::HasSubstr("the duration is too short: expected at least 1ms"))
        << line;
  }
}

TEST(Scenario, CutsThePowerAtAWriteToTheEeprom) {
  const auto steps = parse_scenario(
      "after eeprom 12 power off for 20ms byte erased\n"
      "after eeprom 3 wait 1ms power off 1s byte old\n"
      "after eeprom 3 power off byte 0x5A\n"
      "after eeprom 3 power off byte new\n"
      "after eeprom 3 power off\n",
      "s.txt");
  EXPECT_EQ(steps[0].trigger.kind, Trigger::Kind::eeprom);
  EXPECT_EQ(steps[0].trigger.count, 12u);
  EXPECT_EQ(*steps[0].action.duration, 20 * kMillisecond);
  EXPECT_EQ(steps[0].action.half_written.kind, HalfWritten::Kind::value);
  EXPECT_EQ(steps[0].action.half_written.value, 0xFF);
  EXPECT_EQ(*steps[1].action.duration, kSecond);
  EXPECT_EQ(steps[1].action.half_written.kind, HalfWritten::Kind::before);
  EXPECT_FALSE(steps[2].action.duration);
  EXPECT_EQ(steps[2].action.half_written.value, 0x5A);
  EXPECT_EQ(steps[3].action.half_written.kind, HalfWritten::Kind::done);
  EXPECT_EQ(steps[4].action.half_written.kind, HalfWritten::Kind::done);
}

TEST(Scenario, ReadsOneLineByItself) {
  const auto step = parse_step("at 3s lift", {"typed", 7, 1});
  ASSERT_TRUE(step);
  EXPECT_EQ(step->trigger.time, 3 * kSecond);
  EXPECT_EQ(to_string(step->place), "typed:7");
  EXPECT_FALSE(parse_step("  # nothing", {}));
}

TEST(Scenario, ExplainsEveryMistakeWithItsLineAndColumn) {
  EXPECT_EQ(
      error_of("at 2s prees\n"),
      "s.txt:1:7: unknown verb: expected press, release, send, place, lift, lower, cover, obstacle, "
      "clear, fault, power, sweep, tilt, paint, erase, door or light, got “prees”; did you mean press?");
  EXPECT_EQ(
      error_of("\nafter seriel press b"),
      "s.txt:2:7: unknown event: expected serial, station, boot, eeprom or a part with a text in quotes, "
      "got “seriel”; did you mean serial?");
  EXPECT_EQ(error_of("when 2s press b"),
            "s.txt:1:1: unknown trigger: expected `at TIME` or `after EVENT`, got “when”");
  EXPECT_THAT(error_of("aftr boot 2 lift"), testing::HasSubstr("did you mean after?"));
  EXPECT_THAT(error_of("at 2 press b"),
              testing::StartsWith("s.txt:1:4: invalid time: expected a number with a unit"));
  EXPECT_EQ(error_of("at 2s press"), "s.txt:1:7: the line ends too early: expected a part's name");
  EXPECT_EQ(error_of("at 2s release b now"), "s.txt:1:17: unexpected \"now\": expected the end of the line");
  EXPECT_EQ(error_of("at 2s send \"abc"), "s.txt:1:12: unterminated text: expected a closing double quote");
  EXPECT_THAT(error_of("at 2s send \"\\q\""), testing::HasSubstr("got \\q"));
  EXPECT_EQ(error_of("at 2s fault left dead for"),
            "s.txt:1:23: the line ends too early: expected a time such as 2s or 100ms");
  EXPECT_EQ(error_of("at 2s fault left dead for ever now"),
            "s.txt:1:27: invalid time: expected a number with a unit (ns, us, ms, s, min, h or d), got "
            "\"ever\"");
  EXPECT_EQ(error_of("at 2s obstacle 1,2 radius 9m"),
            "s.txt:1:27: expected a radius from 5mm to 500mm, got \"9m\"");
  EXPECT_EQ(error_of("after eeprom 0 power off"),
            "s.txt:1:14: expected the number of a write from 1 to 1000000000000, got \"0\"");
  EXPECT_EQ(
      error_of("at 2s power off byte erasd"),
      "s.txt:1:22: the half-written byte: expected old, new, erased or a value from 0 to 255, got “erasd”; "
      "did you mean erased?");
  EXPECT_EQ(
      error_of("at 2s power off byte 256"),
      "s.txt:1:22: the half-written byte: expected old, new, erased or a value from 0 to 255, got “256”");
  EXPECT_EQ(error_of("at 2s power of"), "s.txt:1:13: power: expected off or on, got “of”; did you mean off?");
  EXPECT_EQ(error_of("at 2s light all of"),
            "s.txt:1:17: a light: expected on or off, got “of”; did you mean off?");
}

TEST(Scenario, MayBeginWithAByteOrderMark) {
  const auto steps = parse_scenario(
      "\xEF\xBB\xBF"
      "at 2s lift\n",
      "s.txt");
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].place.line, 1);
  EXPECT_THAT(error_of("\xEF\xBB\xBF"
                       "at 2s dance\n"),
              testing::StartsWith("s.txt:1:7: unknown verb"));
}

TEST(Scenario, NamesAFileOfAnotherKind) {
  EXPECT_EQ(error_of("+++\ngoal = \"tour\"\n+++\n"),
            "s.txt: expected a script, got a map; give it with --map");
}

TEST(AFigureWithASpread, IsReadAsWrittenAndDrawnByItsShare) {
  const Step step =
      *parse_step("at 2s+-500ms obstacle 12±2,3 radius 30mm+-10% for 4s  # a can", {"s.txt", 7, 1});
  EXPECT_EQ(step.trigger.time, 2 * kSecond);
  EXPECT_EQ(step.action.text, "12,3");
  const Step least = parse_varied(step, [](std::size_t) { return -1.0; });
  EXPECT_EQ(least.trigger.time, 1500 * kMillisecond);
  EXPECT_EQ(least.action.text, "10,3");
  EXPECT_NEAR(least.action.radius, 0.027, 1e-9);
  EXPECT_EQ(*least.action.duration, 4 * kSecond);
  const Step most = parse_varied(step, [](std::size_t n) { return n == 1 ? 1.0 : 0.0; });
  EXPECT_EQ(most.trigger.time, 2 * kSecond);
  EXPECT_EQ(most.action.text, "14,3");
  EXPECT_TRUE(parse_step("at 1s send \"5+-1\"", {})->varies.empty()) << "texts do not vary";
}

TEST(AFigureWithASpread, IsRefusedWhereNotAllOfItIsAllowed) {
  EXPECT_THAT(error_of("at 2s+-3s lift"),
              testing::HasSubstr("s.txt:1:4: the spread of \"2s+-3s\" reaches below 0"));
  EXPECT_THAT(error_of("at 2s+-3mm lift"),
              testing::HasSubstr("invalid value with a spread: expected an amount"));
  EXPECT_THAT(error_of("at 2s+- lift"), testing::HasSubstr("invalid value with a spread"));
  EXPECT_THAT(error_of("at 2s obstacle 1+-2,3"), testing::HasSubstr("\"1+-2\" reaches below 0"));
  EXPECT_THAT(error_of("at 2s obstacle 1,3 radius 499mm+-2mm"),
              testing::HasSubstr("expected a radius from 5mm to 500mm"));
  EXPECT_THAT(error_of("at 2s tilt 20deg ahead in 1s+-500ms for 2s+-100ms"),
              testing::HasSubstr("a tilt goes there and back"));
}

}  // namespace robosim::scenario::scenario_test
