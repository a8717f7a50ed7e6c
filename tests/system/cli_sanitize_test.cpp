// Tests `--sanitize`, as users pass it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/json_of.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_sanitize_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kSpeeds =
    "int speeds[5];\n"
    "int average() {\n"
    "  int sum = 0;\n"
    "  for (int i = 0; i <= 5; i++) sum += speeds[i];\n"
    "  return sum / 5;\n"
    "}\n"
    "void setup() { Serial.begin(9600); }\n"
    "void loop() { Serial.println(average()); }\n";

TEST(CliSanitize, EndsTheRunAtABadIndexAndNamesItsPlace) {
  const Folder folder;
  folder.write("Speeds/Speeds.ino", kSpeeds);
  std::vector<std::string> words = {"run", "Speeds/", "--goal", "none", "--for", "100ms", "--json"};
  const Ended plain = robosim_command(words, folder.path());
  EXPECT_EQ(plain.status, 0) << plain.out << plain.err;
  EXPECT_FALSE(json_of(plain)["inputs"].contains("sanitize"));
  words.push_back("--sanitize");
  const Ended checked = robosim_command(words, folder.path());
  EXPECT_EQ(checked.status, 1) << checked.err;
  const nlohmann::json result = json_of(checked);
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_EQ(
      result["why"],
      "A check (--sanitize) failed: index 5 is outside of the array, an int [5]: valid indices are 0 to 4 "
      "in average, Speeds.ino:4.");
  EXPECT_EQ(result["crash"]["function"], "average");
  EXPECT_EQ(result["crash"]["file"], "Speeds.ino");
  EXPECT_EQ(result["crash"]["line"], 4);
  EXPECT_EQ(result["crash"]["check"], "out_of_bounds");
  EXPECT_EQ(result["inputs"]["sanitize"], true);
  EXPECT_EQ(robosim_command(words, folder.path()).out, checked.out) << "equal output each time";
}

// The sketch replaces the Arduino core's initVariant() and looks for the end of RAM. FreeRTOS does both, to
// place the stacks of its tasks.
TEST(CliSanitize, OnTheChipASketchMayTakeTheCoresPlaceAndFindsWhereRamEnds) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const Folder folder;
  folder.write("Early/early.cpp",
               "#include <avr/io.h>\nint left;\nextern \"C\" void initVariant() { left = RAMEND - SP; }\n");
  folder.write(
      "Early/Early.ino",
      "extern int left;\n"
      "void setup() { Serial.begin(9600); Serial.println(left > 0 && left < 64 ? \"found\" : \"not\"); }\n"
      "void loop() {}\n");
  for (const char* checks : {"--profile=ideal", "--sanitize"}) {
    const Ended run = robosim_command(
        {"run", "Early/", "--target", "avr", "--goal", "none", "--for", "100ms", "--json", checks},
        folder.path());
    EXPECT_EQ(json_of(run)["serial"], "found\r\n") << checks << run.err;
  }
}

TEST(CliSanitize, OnTheChipItKnowsHowMuchAnIntHolds) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const std::string sum = sketch_folder("ChipSum").string() + "/";
  const Ended run = robosim_command({"run", sum, "--map", "oval", "--target", "avr", "--sanitize", "--json"});
  EXPECT_EQ(run.status, 1) << run.err;
  const nlohmann::json result = json_of(run);
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_EQ(result["crash"]["check"], "mul_overflow");
  EXPECT_THAT(result["why"].get<std::string>(),
              HasSubstr("does not fit an int, which holds -32768 to 32767 here"));
  const Ended build = robosim_command({"build", "AiNavigator", "--target", "avr", "--sanitize"});
  EXPECT_EQ(build.status, 0) << build.err;
  EXPECT_THAT(build.out, HasSubstr("with checks"));
}

// The emulated chip has additional RAM for an image with checks. The verdict must still equal the verdict of
// the flashed image, which has no checks.
TEST(CliSanitize, OnTheChipASketchWithoutRoomForItsStackHasNotPassed) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const Folder folder;
  folder.write("Deep/Deep.ino",
               "byte table[1500];\n"
               "void look() { volatile byte seen[600]; for (int i = 0; i < 600; ++i) seen[i] = i; }\n"
               "void setup() { Serial.begin(9600); }\n"
               "void loop() { Serial.println(++table[millis() % 1500]); look(); delay(10); }\n");
  const Ended run = robosim_command({"run", "Deep/", "--map", "oval", "--robot", "uno5", "--target", "avr",
                                     "--goal", "none", "--for", "200ms", "--sanitize", "--json"},
                                    folder.path());
  EXPECT_EQ(run.status, 1) << run.err;
  const nlohmann::json result = json_of(run);
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_EQ(result["crash"]["line"], 2);
  EXPECT_THAT(result["why"].get<std::string>(),
              AllOf(HasSubstr("With checks the verdict is “reached”; without them, as flashed: "),
                    HasSubstr("stack overflow")));
}

// In the overflow checks of avr-gcc 5, the type `int` has the name of the sketch's first array of `int`.
TEST(CliSanitize, OnTheChipAnArraysTypeIsNotTakenForItsElements) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const Folder folder;
  folder.write(
      "Sum/Sum.ino",
      "void outputs() { int p[] = {5, 6, 7}; for (int i = 0; i < 3; i++) pinMode(p[i], OUTPUT); }\n"
      "void setup() { outputs(); }\n"
      "void loop() { int a = 900 + digitalRead(2); int pos = a * 100; if (pos < 0) tone(11, 440); }\n");
  const Ended run = robosim_command(
      {"run", "Sum/", "--map", "oval", "--robot", "uno5", "--target", "avr", "--sanitize"}, folder.path());
  EXPECT_THAT(run.out, HasSubstr("* 100 does not fit an int"));
}

// After a failure on the chip, Robosim automatically runs the sketch again with checks.
TEST(CliSanitize, ASketchThatFailsOnTheChipRunsAgainWithChecksThatNameTheLine) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const std::string sum = sketch_folder("ChipSum").string() + "/";
  std::vector<std::string> words = {"run", sum, "--map", "oval", "--robot", "uno5", "--target", "avr"};
  const Ended screen = robosim_command(words);
  EXPECT_EQ(screen.status, 1) << screen.err;
  EXPECT_THAT(screen.out,
              AllOf(HasSubstr("\nlost: "), HasSubstr("ChipSum.ino:9"), HasSubstr("as in 1000L *")));
  EXPECT_THAT(screen.out, testing::AnyOf(HasSubstr("\nnext: 1000 * "), HasSubstr(" * 1000 does not fit")))
      << "the compiler chooses the order of the factors";
  words.push_back("--json");
  const nlohmann::json result = json_of(robosim_command(words));
  EXPECT_EQ(result["verdict"], "lost");
  EXPECT_EQ(result["finding"]["check"], "mul_overflow");
  EXPECT_EQ(result["finding"]["file"], "ChipSum.ino");
  EXPECT_EQ(result["finding"]["line"], 9);
}

TEST(CliSanitize, ASketchThatCrashesOnTheHostRunsAgainWithChecksThatNameTheBadAccess) {
  const Folder folder;
  folder.write("Smash/Smash.ino",
               "volatile int n = 200;\n"
               "void fill() {\n"
               "  int local[4];\n"
               "  for (int i = 0; i < n; i++) local[i] = 0x41414141 + i;\n"
               "  n = local[2];\n"
               "}\n"
               "void setup() { delay(5); fill(); }\n"
               "void loop() {}\n");
  std::vector<std::string> words = {"run", "Smash/", "--map", "oval", "--robot", "uno5", "--goal", "none"};
  const Ended screen = robosim_command(words, folder.path());
  EXPECT_EQ(screen.status, 1) << screen.err;
  EXPECT_THAT(screen.out,
              AllOf(HasSubstr("\ncrashed: "), HasSubstr("\nnext: index 4 is outside of the array"),
                    HasSubstr("Smash.ino:4")));
  words.push_back("--json");
  const nlohmann::json result = json_of(robosim_command(words, folder.path()));
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_EQ(result["finding"]["check"], "out_of_bounds");
  EXPECT_EQ(result["finding"]["file"], "Smash.ino");
  EXPECT_EQ(result["finding"]["line"], 4);
}

TEST(CliSanitize, WhereNoCheckFindsAnythingItIsSaidWhatTheyDoNotLookAt) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const Folder folder;
  folder.write("Straight/Straight.ino",
               "void setup() {\n  for (byte pin = 5; pin <= 10; ++pin) pinMode(pin, OUTPUT);\n"
               "  digitalWrite(7, HIGH);\n  digitalWrite(9, HIGH);\n  analogWrite(5, 100);\n"
               "  analogWrite(6, 100);\n}\nvoid loop() { delay(1); }\n");
  const Ended run = robosim_command(
      {"run", "Straight/", "--map", "oval", "--robot", "uno5", "--target", "avr"}, folder.path());
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("next:"), HasSubstr("Not checked: unsigned")));
}

// After a failure, Robosim runs the sketch again with checks. The second run has more memory, so the
// recursion that overflowed the stack returns. Three seconds later, an unrelated check fails.
TEST(CliSanitize, ACheckThatFailsLongAfterTheFirstRunsEndIsNotItsCause) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const Folder folder;
  folder.write("Deep/Deep.ino",
               "volatile int n = 32767;\n"
               "int deep(int left) {\n"
               "  volatile char room[100];\n"
               "  room[0] = left;\n"
               "  return left == 0 ? 0 : deep(left - 1) + room[0];\n"
               "}\n"
               "void setup() { delay(100); deep(30); delay(3000); n++; }\n"
               "void loop() { delay(100); }\n");
  const nlohmann::json result = json_of(robosim_command(
      {"run", "Deep/", "--map", "oval", "--robot", "uno5", "--target", "avr", "--goal", "none", "--json"},
      folder.path()));
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_FALSE(result.contains("finding")) << result["finding"];
}

TEST(CliSanitize, OurOwnSketchDrivesWithoutAFinding) {
  const Ended run = robosim_command({"run", "PidFollower", "--map", "oval", "--robot", "uno5", "--sanitize"});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
}

// --- detectors

/// Returns the findings for a sketch that drives forward and backward, 700 ms each. Its line 5 is `waits`.
nlohmann::json detected_in(const std::string& waits) {
  const Folder folder;
  folder.write(
      "Fro/Fro.ino",
      "void way(bool ahead) {\n"
      "  digitalWrite(7, ahead); digitalWrite(8, !ahead); digitalWrite(9, ahead); digitalWrite(10, !ahead);\n"
      "  analogWrite(5, 80); analogWrite(6, 80);\n"
      "  unsigned long begin = millis(), end = begin + 700;\n" +
          waits +
          "\n}\n"
          "void setup() { Serial.begin(9600); for (int pin = 5; pin <= 10; ++pin) pinMode(pin, OUTPUT); }\n"
          "void loop() { way(true); way(false); }\n");
  const Ended run = robosim_command({"run", "Fro/", "--target", "avr", "--map", "oval", "--robot", "uno5",
                                     "--goal", "none", "--for", "8s", "--sanitize", "--json"},
                                    folder.path());
  EXPECT_EQ(run.status, 0) << run.err;
  return json_of(run).value("detected", nlohmann::json::array());
}

TEST(CliSanitize, TellsWhichDeadlineBreaksWhenMillisGoesBackToZero) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const nlohmann::json seen = detected_in("  while (millis() < end) {}");
  ASSERT_EQ(seen.size(), 1u) << seen;
  EXPECT_EQ(seen[0]["detector"], "clock_wrap");
  EXPECT_EQ(seen[0]["file"], "Fro.ino");
  EXPECT_EQ(seen[0]["line"], 5);
  EXPECT_THAT(seen[0]["what"].get<std::string>(), HasSubstr("when millis() goes back to 0"));
  const nlohmann::json none = detected_in("  while (millis() - begin < 700) {}");
  EXPECT_TRUE(none.empty()) << none;
  // After the wrap the numbers are shorter and take less time on the serial port.
  const nlohmann::json prints = detected_in(
      "  while (millis() - begin < 700) {}\n  for (int i = 0; i < 40; i++) Serial.println(millis());");
  EXPECT_TRUE(prints.empty()) << prints;
}

TEST(CliSanitize, BlamesNoSketchForAWrapThatAnyOtherMicrosecondTurnsAside) {
  if (const std::string missing = what_is_missing("avr"); !missing.empty()) GTEST_SKIP() << missing;
  const nlohmann::json seconds = detected_in(
      "  while (millis() - begin < 700) {}\n  for (int i = 0; i < 40; i++) Serial.println(millis() / 1000);");
  EXPECT_TRUE(seconds.empty()) << seconds;
  // The time of the conversion to float depends on the value.
  const nlohmann::json by_count = detected_in(
      "  unsigned n = 0;\n  while (millis() - begin < 700) { volatile float f = millis(); n++; }\n"
      "  if (n % 2) delay(300);");
  EXPECT_TRUE(by_count.empty()) << by_count;
  const nlohmann::json seen = detected_in("  while (millis() < end) {}\n  Serial.println(millis() / 1000);");
  ASSERT_EQ(seen.size(), 1u) << seen;
  EXPECT_EQ(seen[0]["detector"], "clock_wrap");
}

}  // namespace cli_sanitize_test
}  // namespace robosim::test
