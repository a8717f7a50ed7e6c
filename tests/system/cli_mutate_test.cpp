// Tests `robosim mutate`, as users run it, in runs of 50 ms. The sketch has few places for bugs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/require_target.h"
#include "tests/system/command.h"
#include "tests/system/json_of.h"

namespace robosim::test {
namespace cli_mutate_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class CliMutate : public ::testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_CLANG();
    folder_.write("Greets/Greets.ino",
                  "int unused;\nvoid setup() { Serial.begin(9600); Serial.println(\"hello\"); }\n"
                  "void loop() { unused = 1; }\n");
    checks("serial = \"hello\"\n");
  }
  void checks(const std::string& more) {
    folder_.write("Greets/checks.toml",
                  "[[check]]\nname = \"greets\"\ngoal = \"none\"\nfor = \"50ms\"\nmap = \"oval\"\n" + more);
  }
  Ended mutate(std::vector<std::string> words) {
    words.insert(words.begin(), "mutate");
    return robosim_command(words, folder_ / "Greets");
  }

  Folder folder_;
};

TEST_F(CliMutate, TellsWhichBugsNoCheckFinds) {
  const Ended ended = mutate({"--count", "100"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out, StartsWith("Greets: "));
  EXPECT_THAT(ended.out, HasSubstr("without any effect in these runs:\n"));
  EXPECT_THAT(ended.out, HasSubstr("  Greets.ino:3  constant: `0` for `1`\n"));
  EXPECT_THAT(ended.out, HasSubstr("harmless changes: all checks pass, as they should\n"));
}

TEST_F(CliMutate, DrawsTheSameBugsForASeedWhateverTheNumberOfJobs) {
  const Ended first = mutate({"--count", "4", "--seed", "3", "--jobs", "1", "--json"});
  const Ended again = mutate({"--count", "4", "--seed", "3", "--jobs", "2", "--json"});
  EXPECT_EQ(first.out, again.out);
  const auto json = nlohmann::json::parse(first.out);
  EXPECT_EQ(json["schema"], "robosim.mutate/1");
  EXPECT_EQ(json["mutants"].size(), 4u);
  const Ended other = mutate({"--count", "4", "--seed", "4", "--jobs", "1", "--json"});
  EXPECT_NE(nlohmann::json::parse(other.out)["mutants"], json["mutants"]);
}

TEST_F(CliMutate, FindsWhatIsLeftOut) {
  const auto json = nlohmann::json::parse(mutate({"--count", "100", "--json"}).out);
  int found = 0;
  for (const auto& mutant : json["mutants"])
    if (mutant["was"] == "Serial.println(\"hello\")") {
      EXPECT_EQ(mutant["result"], "found");
      EXPECT_EQ(mutant["check"], "greets");
      ++found;
    }
  EXPECT_EQ(found, 1);
}

TEST_F(CliMutate, HasAStatusForTooFewThatAreFound) {
  checks("");  // no requirements
  EXPECT_EQ(mutate({"--count", "3", "--min-score", "0"}).status, 0);
  EXPECT_EQ(mutate({"--count", "8", "--min-score", "0.9"}).status, 1);
}

TEST_F(CliMutate, NamesACheckThatMindsWhatIsHarmless) {
  folder_.write("Greets/Greets.ino",
                "void setup() { Serial.begin(9600); Serial.println(millis()); }\nvoid loop() {}\n");
  checks("serial = \"0\"\n");
  const Ended ended = mutate({"--count", "1"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.out,
              HasSubstr("brittle: the check \"greets\" fails where it should not, with `{ delay("));
}

TEST_F(CliMutate, RefusesWhatItCannotTry) {
  EXPECT_THAT(mutate({"--count", "0"}).err, HasSubstr("--count"));
  EXPECT_EQ(mutate({"--min-score", "2"}).status, 2);
  checks("serial = \"good bye\"\n");
  const Ended fails = mutate({});
  EXPECT_EQ(fails.status, 2);
  EXPECT_THAT(fails.err, HasSubstr("the check \"greets\" fails even without a bug"));
  std::filesystem::remove(folder_ / "Greets/checks.toml");
  EXPECT_THAT(mutate({}).err, HasSubstr("no such file: “robosim mutate” requires a file of checks"));
}

TEST_F(CliMutate, TriesTestsInCPlusPlus) {
  const std::string tests = ROBOSIM_FIRMWARE_TESTS;
  ::setenv("GTEST_FILTER", "On/Shuttle.Drives*/host", 1);
  const Ended ended = robosim_command({"mutate", "tests/firmware/sketches/Shuttle", "--tests", tests,
                                       "--count", "2", "--seed", "1", "--json"},
                                      data_folder());
  ::unsetenv("GTEST_FILTER");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["tests"], tests);
  const auto is_found = [](const auto& mutant) {
    return mutant["result"] == "found" &&
           mutant["check"] == "Shuttle.DrivesTwentyCentimetresForwardAndBackAgainAndAgain";
  };
  EXPECT_EQ(std::count_if(json["mutants"].begin(), json["mutants"].end(), is_found), json["found"]) << json;
  EXPECT_GE(json["found"], 1);
  for (const auto& control : json["controls"]) EXPECT_NE(control["result"], "found") << control;
}

TEST_F(CliMutate, RefusesWhatIsNoProgramOfTests) {
  EXPECT_THAT(mutate({"--tests", "Greets.ino"}).err,
              HasSubstr("Greets.ino: expected a built program of GoogleTest tests"));
  const Ended ended = mutate({"--tests", "/bin/true"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("true ended with status 0, but wrote no report, unlike GoogleTest"));
}

}  // namespace cli_mutate_test
}  // namespace robosim::test
