// Tests `robosim hunt`, as users run it, with sketches that have one bug each, in runs of 2 s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_hunt_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CliHunt : public ::testing::Test {
 protected:
  void sketch(const std::string& in_loop) {
    folder_.write("Tries/Tries.ino",
                  "void setup() { pinMode(4, INPUT_PULLUP); Serial.begin(9600); }\n"
                  "void loop() {\n" +
                      in_loop + "\n  delay(5);\n}\n");
  }
  Ended hunt(std::vector<std::string> words = {}, const char* runs = "24") {
    words.insert(words.begin(), {"hunt", "./Tries", "--for", "2s", "--runs", runs});
    if (std::find(words.begin(), words.end(), "--target") == words.end())
      words.insert(words.end(), {"--target", "host"});
    return robosim_command(words, folder_.path());
  }
  Ended command(const std::vector<std::string>& words) { return robosim_command(words, folder_.path()); }

  Folder folder_;
};

constexpr const char* kCrashesWhenPressed =
    "  static bool was;\n  const bool is = digitalRead(4) == LOW;\n"
    "  if (is && !was) { int* nothing = 0; *nothing = 1; }\n  was = is;";

TEST_F(CliHunt, FindsWhatAButtonBringsAboutAndLeavesTheSmallestRunThatShowsIt) {
  sketch(kCrashesWhenPressed);
  const Ended ended = hunt();
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("null pointer"), HasSubstr("in loop, Tries.ino:5."),
                               HasSubstr("oval; needs: press start\n"), Not(HasSubstr("finding 2"))));
  EXPECT_THAT(ended.err, HasSubstr("in loop, Tries.ino:5. Looking for the smallest world"));
  for (const char* file : {"hunt-Tries/1/run.html", "hunt-Tries/1/script.txt", "hunt-Tries/checks.toml"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / file)) << file;

  const std::size_t at = ended.out.find("replay  robosim ") + 16;
  std::vector<std::string> words;
  std::istringstream replay(ended.out.substr(at, ended.out.find('\n', at) - at));
  for (std::string word; replay >> word;) words.push_back(word);
  EXPECT_THAT(command(words).out, HasSubstr("crashed"));

  const std::vector<std::string> test{"test", "./Tries", "--checks", "hunt-Tries/checks.toml"};
  EXPECT_EQ(command(test).status, 1);
  sketch("  if (digitalRead(4) == LOW) Serial.println(\"pressed\");");
  EXPECT_EQ(command(test).status, 0);
}

TEST_F(CliHunt, FindsTheSameWhateverTheNumberOfJobs) {
  sketch(kCrashesWhenPressed);
  const Ended one = hunt({"--jobs", "1", "--out", "found"});
  std::filesystem::remove_all(folder_ / "found");
  EXPECT_EQ(hunt({"--jobs", "3", "--out", "found"}).out, one.out);
}

TEST_F(CliHunt, FindsWhatOnlyAMessageBringsAboutSinceItKnowsTheSketchsWords) {
  sketch("  if (Serial.readStringUntil('\\n') == \"reset\") { int* nothing = 0; *nothing = 1; }");
  const Ended ended = hunt({"--stop-early"}, "120");
  EXPECT_THAT(ended.out, AllOf(HasSubstr("null pointer"), HasSubstr("; needs: send\n"))) << ended.err;
}

TEST_F(CliHunt, TellsOnceWhatSeveralMachinesHaveFound) {
  sketch(kCrashesWhenPressed);
  hunt({"--shard", "1/2", "--out", "part1"});
  const Ended second = hunt({"--shard", "2/2", "--out", "part2"});
  EXPECT_THAT(second.out, HasSubstr("12 runs, ")) << second.err;
  const Ended all = hunt({"--merge", "part1", "part2", "--out", "all"});
  EXPECT_EQ(all.status, 1) << all.err;
  EXPECT_THAT(all.out, AllOf(HasSubstr("--script all/1/script.txt"), HasSubstr("24 runs, "),
                             HasSubstr("null pointer"), Not(HasSubstr("finding 2"))));
  EXPECT_EQ(command({"test", "./Tries", "--checks", "all/checks.toml"}).status, 1);

  const Ended half = hunt({"--merge", "part2", "--out", "half"});
  EXPECT_THAT(half.err, HasSubstr("shard 1/2 is missing"));
  const Ended other = hunt({"--merge", "part1", "part2", "--out", "other", "--seed", "2"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("part1/runs.jsonl:1: belongs to another hunt"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
}

TEST_F(CliHunt, TellsWhatADetectorSeesAndLeavesACheckOfIt) {
  const auto saves_by = [&](const char* call) {
    folder_.write("Tries/Tries.ino", "#include <EEPROM.h>\nvoid setup() {}\nvoid loop() {\n  EEPROM." +
                                         std::string(call) + "(0, 7);\n  delay(5);\n}\n");
  };
  saves_by("write");
  const Ended ended = hunt({}, "12");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("in loop, Tries.ino:4"), HasSubstr("EEPROM"),
                               HasSubstr("no other conditions"), HasSubstr("--sanitize\n")));
  const std::vector<std::string> test{"test", "./Tries", "--checks", "hunt-Tries/checks.toml"};
  EXPECT_THAT(command(test).out, AllOf(HasSubstr("why: detected: "), HasSubstr("--sanitize --view")));
  saves_by("update");
  EXPECT_EQ(command(test).status, 0);
}

TEST_F(CliHunt, TellsWhereTheChipDoesNotDoAsTheHostDoes) {
  ROBOSIM_NEEDS_TARGET("avr");
  sketch(
      "  static bool said;\n  const unsigned edges = 600 + millis() / 60000, um = 326;\n"
      "  if (!said) { Serial.print(edges * um / 1000); Serial.println(\" mm\"); }\n  said = true;");
  const Ended ended = hunt({"--target", "avr", "host"}, "12");
  EXPECT_THAT(
      ended.out,
      AllOf(
          HasSubstr("finding 1: The host says “195 mm”, but the avr says “64 mm”; noise is not the reason."),
          HasSubstr("replay  robosim compare ./Tries --map oval --target host,avr "),
          Not(HasSubstr("finding 2"))))
      << ended.err;
}

TEST_F(CliHunt, SaysNothingOfASketchThatDoesNothingWrong) {
  sketch("  if (digitalRead(4) == LOW) Serial.println(Serial.read());");
  const Ended ended = hunt();
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_THAT(ended.out, HasSubstr("24 runs, 48 s of simulated time: nothing was found\n"));
}

TEST_F(CliHunt, TellsOfARobotThatDoesNotDriveWhateverIsDoneToIt) {
  const auto drives_if = [&](const char* level) {
    sketch(
        "  pinMode(5, OUTPUT), pinMode(7, OUTPUT), pinMode(6, OUTPUT), pinMode(9, OUTPUT);\n"
        "  digitalWrite(7, HIGH), digitalWrite(9, HIGH);\n"
        "  const bool goes = digitalRead(4) == " +
        std::string(level) + ";\n  analogWrite(5, goes ? 90 : 0), analogWrite(6, goes ? 90 : 0);");
    return hunt({}, "12").out;
  };
  EXPECT_THAT(
      drives_if("2"),
      HasSubstr("nothing was found\nthe robot never drove, with any of the inputs tried; the first run "
                "ended so: The 2.00 s of simulated time are up"));
  EXPECT_THAT(drives_if("LOW"), Not(HasSubstr("the robot never drove")));
}

TEST_F(CliHunt, BlamesNoFollowerOfLoopsForFloorsThatItToursByLuckIfAtAll) {
  folder_.write("Tries/Tries.ino",
                "#include <LineKit.h>\n"
                "const uint8_t PINS[] = {A0, A1, A2, A3, A4};\n"
                "AnalogLineSensors sensors(PINS);\n"
                "DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));\n"
                "int side = 1;\n"
                "void setup() { sensors.begin(); sensors.setRange(110, 880); motors.begin(); }\n"
                "void loop() {\n"
                "  sensors.read();\n"
                "  const int off = sensors.position();\n"
                "  if (off > 500) side = 1;\n"
                "  if (off < -500) side = -1;\n"
                "  if (sensors.seesLine()) motors.drive(80 + off / 20, 80 - off / 20);\n"
                "  else motors.drive(side * 75, side * -75);\n"  // turns around at the end of a line
                "  delay(5);\n"
                "}\n");
  const char* const kSays =
      "the sketch reaches its goal on the map a, but not on most similar floors: findings about its driving "
      "on such "
      "floors are reported only with --map a\n";
  const std::vector<std::string> hunt = {"hunt", "./Tries", "--runs", "96", "--target", "host"};
  const Ended guessed = command(hunt);
  EXPECT_EQ(guessed.status, 0) << guessed.out;
  EXPECT_THAT(guessed.out, HasSubstr(kSays));
  std::vector<std::string> asked = hunt;
  asked.insert(asked.end(), {"--map", "a", "--out", "asked"});
  const Ended told = command(asked);
  EXPECT_EQ(told.status, 1) << told.out;
  EXPECT_THAT(told.out, AllOf(HasSubstr("a drawn map"), Not(HasSubstr(kSays))));
}

TEST_F(CliHunt, GoesOnWhereItWasAndFindsWhatOneGoWouldHave) {
  sketch(kCrashesWhenPressed);
  const Ended whole = hunt({"--out", "found"}, "40");
  std::filesystem::remove_all(folder_ / "found");
  hunt({"--out", "found"}, "15");
  EXPECT_EQ(hunt({"--out", "found", "--resume"}, "40").out, whole.out);
  const Ended other = hunt({"--out", "found", "--resume", "--seed", "2"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("found/runs.jsonl:1: belongs to another hunt"));
  EXPECT_THAT(hunt({"--out", "none", "--resume"}).err,
              HasSubstr("none: expected the folder of a hunt for --resume"));
}

TEST_F(CliHunt, KeepsWhatMustNeverSometimesAndAlwaysBe) {
  sketch("  if (digitalRead(4) == LOW) Serial.println(\"ouch\");");
  folder_.write("Tries/checks.toml",
                "never = \"serial: ouch\"\nsometimes = [\"serial: ou\", \"serial: hello\"]\n");
  const Ended ended = hunt();
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("finding 1: The sketch sent “ouch”, which it must never do.\n"),
                    HasSubstr("; needs: press start\n"),
                    HasSubstr("This must occur in some run, but did not in any of 24 runs: serial: hello.")));
  EXPECT_THAT(ended.out, Not(HasSubstr("finding 3")));
  const Ended test = command({"test", "./Tries", "--checks", "hunt-Tries/checks.toml"});
  EXPECT_THAT(test.out, HasSubstr("the sketch sent “ouch”, which it must never do"));
}

TEST_F(CliHunt, RefusesWhatItCannotDo) {
  sketch("");
  EXPECT_THAT(hunt({"--minutes", "none"}).err,
              HasSubstr("--minutes: expected a number above 0, at most 10000, got “none”"));
  std::filesystem::create_directory(folder_ / "hunt-Tries");
  const Ended there = hunt();
  EXPECT_EQ(there.status, 2);
  EXPECT_THAT(there.err, HasSubstr("hunt-Tries: exists already; --resume continues it"));
}

}  // namespace cli_hunt_test
}  // namespace robosim::test
