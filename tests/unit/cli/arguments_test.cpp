#include "sim/cli/arguments.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/result/detector_names.h"
#include "tests/support/readable.h"
#include "tests/support/refusal.h"

namespace robosim::cli::arguments_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <typename T>
T parsed(const std::vector<std::string>& words) {
  return std::get<T>(parse_arguments(words));
}

std::string refusal(const std::vector<std::string>& words) {
  return test::refusal([&] { parse_arguments(words); }, "");
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
  EXPECT_FALSE(plain.baud) << "the board determines the baud rate";
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
  EXPECT_EQ(generate.size, 12);
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

TEST(Arguments, HelpAndVersionAreTexts) {
  EXPECT_THAT(parsed<PrintText>({"--version"}).text, HasSubstr("robosim 0."));
  EXPECT_THAT(parsed<PrintText>({"--help"}).text, HasSubstr("Exit status"));
  EXPECT_THAT(parsed<PrintText>({"run", "--help"}).text, HasSubstr("--profile PROFILE"));
  for (const result::DetectorName& one : result::kDetectorNames)
    EXPECT_THAT(parsed<PrintText>({"run", "--help"}).text, HasSubstr(std::string(one.name)));
  EXPECT_THAT(parsed<PrintText>({"map", "show", "--help"}).text, HasSubstr("--start X,Y,DIR"));
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
        Refused{{"rnu"}, "there is no command “rnu”; did you mean run? There are new, run, "},
        Refused{{"--verson"}, "did you mean --version?"},
        Refused{{"compare", "--target", "avr"}, "expected two or more targets"},
        Refused{{"compare", "--target", "avr,avr"}, "--target avr is given twice"},
        Refused{{"compare", "--seed", "1", "--seeds", "1..2"}, "give one of them"},
        Refused{{"compare", "--target", "A=host,avr"},
                "unknown robot; this run has one robot, without a name"},
        Refused{{"compare", "--target", "A=host,avr", "--target", "B=host,avr"},
                "for one of them, as in B=host,avr"},
        Refused{{"run", "--mapp", "x"},
                "run: unknown option --mapp; did you mean --map? See robosim help run"},
        Refused{{"run", "--sed=3"}, "did you mean --seed?"},
        Refused{{"run", "-x"}, "run: unknown option -x; see robosim help run"},
        Refused{{"run", "a", "b"}, "run: unexpected argument “b”"},
        Refused{{"run", "--map"}, "--map requires a value: expected --map MAP"},
        Refused{{"run", "--map="}, "--map requires a value: expected --map MAP"},
        Refused{{"sweep", "--target"}, "--target requires a value: expected --target TARGET"},
        Refused{{"run", "--map=a", "b", "c", "--map", "a"}, "--map is given more than once"},
        Refused{{"run", "--map", "a", "--map", "b"}, "--map is given more than once"},
        Refused{{"run", "--for", "60"}, "--for: expected a time above 0 with its unit, as in 60s"},
        Refused{{"run", "--for", "0s"}, "“0s”"}, Refused{{"run", "--for", "-1s"}, "“-1s”"},
        Refused{{"run", "--seed", "-1"},
                "--seed: expected a whole number from 0 to 18446744073709551615, got “-1”"},
        Refused{{"run", "--seed", "18446744073709551616"}, "18446744073709551615"},
        Refused{{"run", "--seed", "1x"}, "“1x”"},
        Refused{{"run", "--profile", "real"},
                "--profile: expected ideal, typical, typical@1 or typical@2, got “real”"},
        Refused{{"run", "--view", "--speed", "-2"}, "got “-2”"},
        Refused{{"run", "--view", "--speed", "nan"}, "got “nan”"},
        Refused{{"run", "--speed", "2"}, "--speed requires --view"},
        Refused{{"run", "--view", "--json"}, "one of them"},
        Refused{{"build", "--warnings", "some"}, "none, default, more or all"},
        Refused{{"map"}, "robosim map requires an action: check, show, graph, generate, import or print"},
        Refused{{"map", "print", "d"}, "map print requires --out"},
        Refused{{"map", "print", "d", "--out", "x.pdf", "--paper", "A5"},
                "--paper: expected A4 or A3, got “A5”"},
        Refused{{"map", "print", "d", "--out", "x.pdf", "--margin", "50mm"},
                "--margin: expected a length from 0 to 40 mm"},
        Refused{{"map", "shwo"},
                "map: unknown action: expected check, show, graph, generate, import or print, got "
                "“shwo”; did you mean show?"},
        Refused{{"map", "show"}, "robosim map show requires a map"},
        Refused{{"map", "show", "d", "--json"}, "map show: unknown option --json"},
        Refused{{"map", "graph", "d", "--json", "--dot"}, "either --json or --dot"},
        Refused{{"map", "generate", "--stations", "5"}, "robosim map generate requires --family"},
        Refused{{"map", "generate", "--family", "tree"},
                "robosim map generate --family tree requires --stations"},
        Refused{{"map", "generate", "--family", "track", "--stations", "5"},
                "robosim map generate --family track requires --squares"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "5", "--squares", "5"},
                "--squares is for tracks"},
        Refused{{"map", "generate", "--family", "bush", "--stations", "5"},
                "--family: expected tree, cycles, grid or track, got “bush”"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "1"},
                "--stations: expected a whole number from 2 to 1000000, got “1”"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "5", "--count", "0"}, "--count"},
        Refused{{"map", "generate", "--family", "tree", "--stations", "5", "--count", "2", "--seed",
                 "18446744073709551615"},
                "fewer maps, because the last seed is 18446744073709551615"},
        Refused{{"flash", "My"}, "robosim flash requires the board's port, as in --port /dev/ttyACM0"},
        Refused{{"flash", "--port", "p", "--baud", "fast"},
                "--baud: expected a whole number from 300 to 2000000, got “fast”"},
        Refused{{"robot", "show"}, "robosim robot show requires a robot"},
        Refused{{"robot", "list", "x"}, "robot list: unexpected argument “x”"},
        Refused{{"test", "--jobs", "0"}, "--jobs: expected a whole number from 1 to 1024, got “0”"},
        Refused{{"new"}, "robosim new requires a name"},
        Refused{{"new", "a", "b"}, "new: unexpected argument “b”"}),
    test::numbered(&Refused::words));

}  // namespace robosim::cli::arguments_test
