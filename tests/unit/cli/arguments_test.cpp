#include "sim/cli/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/readable.h"

namespace robosim::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <typename T>
T parsed(const std::vector<std::string>& words) {
  return std::get<T>(parse_arguments(words));
}

std::string refusal(const std::vector<std::string>& words) {
  try {
    parse_arguments(words);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Arguments, RunHasDefaultsForEverything) {
  const auto run = parsed<RunArguments>({"run"});
  EXPECT_EQ(run.sketch, "");
  EXPECT_EQ(run.target, "");
  EXPECT_EQ(run.request.for_ns, 600'000'000'000);
  EXPECT_EQ(run.request.seed, 1u);
  EXPECT_EQ(run.request.profile, "typical");
  EXPECT_EQ(run.speed, 1.0);
  EXPECT_FALSE(run.view || run.json || run.timing);
}

TEST(Arguments, RunTakesEveryOption) {
  const auto run = parsed<RunArguments>(
      {"run",         "--map", "oval",        "My",     "--robot",        "uno3",   "--target", "avr",
       "--start",     "1,2,E", "--goal",      "laps:3", "--for",          "1.5s",   "--seed",   "7",
       "--profile",   "ideal", "--script",    "s.txt",  "--send",         "go\\n",  "--send",   "2",
       "--libraries", "a",     "--libraries", "b",      "--record=x.csv", "--json", "--timing"});
  EXPECT_EQ(run.sketch, "My");
  EXPECT_EQ(run.map, "oval");
  EXPECT_EQ(run.robot, "uno3");
  EXPECT_EQ(run.target, "avr");
  EXPECT_EQ(run.request.start, "1,2,E");
  EXPECT_EQ(run.request.goal, "laps:3");
  EXPECT_EQ(run.request.for_ns, 1'500'000'000);
  EXPECT_EQ(run.request.seed, 7u);
  EXPECT_EQ(run.request.profile, "ideal");
  EXPECT_EQ(run.script, "s.txt");
  EXPECT_THAT(run.send, ElementsAre("go\\n", "2"));
  EXPECT_THAT(run.libraries, ElementsAre("a", "b"));
  EXPECT_THAT(run.record, ElementsAre("x.csv"));
  EXPECT_TRUE(run.json && run.timing);
}

TEST(Arguments, AListOptionDoesNotSwallowTheSketch) {
  const auto run = parsed<RunArguments>({"run", "--libraries", "lib", "My"});
  EXPECT_THAT(run.libraries, ElementsAre("lib"));
  EXPECT_EQ(run.sketch, "My");
}

TEST(Arguments, ViewHasASpeed) {
  const auto run = parsed<RunArguments>({"run", "--view", "--speed", "0.5"});
  EXPECT_TRUE(run.view);
  EXPECT_EQ(run.speed, 0.5);
  EXPECT_EQ(parsed<RunArguments>({"run", "--view", "--speed", "0"}).speed, 0.0);
}

TEST(Arguments, FlashTakesItsWords) {
  const auto plain = parsed<FlashArguments>({"flash", "--port", "/dev/ttyACM0"});
  EXPECT_EQ(plain.sketch, "");
  EXPECT_EQ(plain.port, "/dev/ttyACM0");
  EXPECT_FALSE(plain.baud) << "the board's";
  EXPECT_FALSE(plain.dry_run);
  const auto all = parsed<FlashArguments>({"flash", "My", "--port", "p", "--robot", "r.toml", "--baud",
                                           "57600", "--libraries", "l", "--dry-run"});
  EXPECT_EQ(all.sketch, "My");
  EXPECT_EQ(all.robot, "r.toml");
  EXPECT_EQ(all.baud, 57'600u);
  EXPECT_THAT(all.libraries, ElementsAre("l"));
  EXPECT_TRUE(all.dry_run);
}

TEST(Arguments, OtherCommandsTakeTheirWords) {
  const auto build = parsed<BuildArguments>(
      {"build", "My", "--robot", "r.toml", "--libraries", "l", "--target", "avr", "--out", "o"});
  EXPECT_EQ(build.target, "avr");
  EXPECT_EQ(build.out, "o");
  EXPECT_EQ(build.sketch, "My");
  EXPECT_EQ(build.robot, "r.toml");
  const auto map = parsed<MapArguments>({"map", "show", "d", "--start", "1,2,E"});
  EXPECT_EQ(map.action, "show");
  EXPECT_EQ(map.map, "d");
  EXPECT_EQ(map.start, "1,2,E");
  EXPECT_TRUE(parsed<MapArguments>({"map", "graph", "d", "--json"}).json);
  EXPECT_TRUE(parsed<MapArguments>({"map", "graph", "--dot", "d"}).dot);
  const auto generate = parsed<GenerateArguments>({"map", "generate", "--family", "tree", "--stations", "12",
                                                   "--count", "3", "--seed", "7", "--out", "maps"});
  EXPECT_EQ(generate.family, "tree");
  EXPECT_EQ(generate.stations, 12);
  EXPECT_EQ(generate.count, 3u);
  EXPECT_EQ(generate.seed, 7u);
  EXPECT_EQ(generate.out, "maps");
  EXPECT_EQ(parsed<RobotArguments>({"robot", "list"}).action, "list");
  EXPECT_EQ(parsed<RobotArguments>({"robot", "check", "x.toml"}).robot, "x.toml");
  EXPECT_TRUE(parsed<RobotArguments>({"robot", "show", "x.toml", "--full"}).full);
  EXPECT_THAT(parsed<TestArguments>({"test"}).sketches, testing::IsEmpty());
  const TestArguments test = parsed<TestArguments>({"test", "a/", "b/", "--checks", "c", "--junit", "j"});
  EXPECT_THAT(test.sketches, testing::ElementsAre("a/", "b/"));
  EXPECT_EQ(test.checks, "c");
  EXPECT_EQ(test.junit, "j");
  EXPECT_EQ(parsed<NewArguments>({"new", "demo"}).name, "demo");
}

TEST(Arguments, ABareCommandPrintsSevenExamples) {
  const std::string text = parsed<PrintText>({}).text;
  int examples = 0;
  for (std::size_t at = 0; (at = text.find("\n  robosim ", at)) != std::string::npos; ++at) ++examples;
  EXPECT_EQ(examples, 7);
}

TEST(Arguments, HelpAndVersionAreTexts) {
  EXPECT_THAT(parsed<PrintText>({"--version"}).text, HasSubstr("robosim 0."));
  EXPECT_THAT(parsed<PrintText>({"--help"}).text, HasSubstr("Exit status"));
  EXPECT_THAT(parsed<PrintText>({"run", "--help"}).text, HasSubstr("--profile PROFILE"));
  EXPECT_THAT(parsed<PrintText>({"map", "--help"}).text, HasSubstr("--start"));
  EXPECT_THAT(parsed<PrintText>({"robot", "show", "-h"}).text, HasSubstr("ROBOT"));
}

struct Refused {
  std::vector<std::string> words;
  const char* says;
};

class RefusedArguments : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedArguments, AreToldInASentence) {
  EXPECT_THAT(refusal(GetParam().words), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedArguments,
    ::testing::Values(
        Refused{{"rnu"}, "there is no command “rnu”; did you mean run? There are run, "},
        Refused{{"--verson"}, "did you mean --version?"},
        Refused{{"compare", "--target", "avr"}, "give two or more"},
        Refused{{"compare", "--target", "avr,avr"}, "--target avr is given twice"},
        Refused{{"compare", "--seed", "1", "--seeds", "1..2"}, "give one of them"},
        Refused{{"compare", "--target", "A=host,avr"}, "there is one robot, without a name"},
        Refused{{"compare", "--target", "A=host,avr", "--target", "B=host,avr"}, "or one of them, as in"},
        Refused{{"run", "--mapp", "x"}, "run has no option --mapp; did you mean --map?"},
        Refused{{"run", "--sed=3"}, "did you mean --seed?"},
        Refused{{"run", "-x"}, "run has no option -x; see"},
        Refused{{"run", "a", "b"}, "“b” is one word too many"},
        Refused{{"run", "--map"}, "--map needs a value after it"},
        Refused{{"run", "--map="}, "--map needs a value after it"},
        Refused{{"sweep", "--target"}, "--target needs a value after it"},
        Refused{{"run", "--map=a", "b", "c", "--map", "a"}, "--map is given more than once"},
        Refused{{"run", "--map", "a", "--map", "b"}, "--map is given more than once"},
        Refused{{"run", "--for", "60"},
                "--for: “60” is not possible; it must be a time above 0 with its unit"},
        Refused{{"run", "--for", "0s"}, "“0s”"}, Refused{{"run", "--for", "-1s"}, "“-1s”"},
        Refused{{"run", "--seed", "-1"}, "--seed: “-1” is not possible; it must be a whole number"},
        Refused{{"run", "--seed", "18446744073709551616"}, "18446744073709551615"},
        Refused{{"run", "--seed", "1x"}, "“1x”"},
        Refused{{"run", "--profile", "real"}, "must be ideal, typical, typical@1 or typical@2"},
        Refused{{"run", "--view", "--speed", "-2"}, "--speed: “-2”"},
        Refused{{"run", "--view", "--speed", "nan"}, "--speed: “nan”"},
        Refused{{"run", "--speed", "2"}, "give --view too"},
        Refused{{"run", "--view", "--json"}, "one of them"},
        Refused{{"build", "--warnings", "some"}, "none, default, more or all"},
        Refused{{"map"},
                "robosim map needs to know what to do: check, show, graph, generate, import or print"},
        Refused{{"map", "print", "d"}, "map print needs --out"},
        Refused{{"map", "print", "d", "--out", "x.pdf", "--paper", "A5"}, "it must be A4 or A3"},
        Refused{{"map", "print", "d", "--out", "x.pdf", "--margin", "50mm"}, "it must be 0 to 40 mm"},
        Refused{{"map", "shwo"}, "robosim map cannot “shwo”; did you mean show?"},
        Refused{{"map", "show"}, "robosim map show needs a map"},
        Refused{{"map", "show", "d", "--json"}, "map show has no option --json"},
        Refused{{"map", "graph", "d", "--json", "--dot"}, "either --json or --dot"},
        Refused{{"map", "generate", "--stations", "5"}, "robosim map generate needs --family"},
        Refused{{"map", "generate", "--family", "tree"}, "robosim map generate needs --stations"},
        Refused{{"map", "generate", "--family", "bush", "--stations", "5"},
                "--family: “bush” is not possible; it must be tree, cycles or grid"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "1"},
                "--stations: “1” is not possible; it must be a whole number from 2 to 1000000"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "5", "--count", "0"}, "--count"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "5", "--count", "2", "--seed",
                 "18446744073709551615"},
                "the seeds end"},
        Refused{{"flash", "My"}, "robosim flash needs the board's port, as in --port /dev/ttyACM0"},
        Refused{{"flash", "--port", "p", "--baud", "fast"},
                "--baud: “fast” is not possible; it must be a whole"},
        Refused{{"robot", "show"}, "robosim robot show needs a robot"},
        Refused{{"robot", "list", "x"}, "robot list: “x” is one word too many"},
        Refused{{"test", "--jobs", "0"}, "--jobs: “0” is not possible"},
        Refused{{"new"}, "robosim new needs a name"},
        Refused{{"new", "a", "b"}, "new: “b” is one word too many"}),
    test::numbered(&Refused::words));

}  // namespace
}  // namespace robosim::cli
