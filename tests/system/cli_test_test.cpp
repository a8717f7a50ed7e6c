// Tests `robosim test` and `robosim new`, as users run them, with short runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/system/command.h"

namespace robosim::test {
namespace cli_test_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

using Words = std::vector<std::string>;

const std::string kGreets =
    "void setup() { Serial.begin(9600); Serial.println(\"hello\"); }\nvoid loop() { delay(1); }\n";

const std::string kShortCheck = "goal = \"none\"\nfor = \"50ms\"\nmap = \"oval\"\n";

/// Returns a `[[check]]` of 50 ms.
std::string check(const std::string& name, const std::string& more) {
  return "[[check]]\nname = \"" + name + "\"\n" + kShortCheck + more + "\n";
}

TEST(CliTest, TellsOfEachCheckWhetherItPassedAndIfNotWhyAndWhatShowsIt) {
  const Folder folder;
  folder.write("Greets/Greets.ino", kGreets);
  folder.write("Greets/checks.toml", check("greets", "serial = \"hello\"") +
                                         check("asks back", "serial = [\"hello\", \"how are you\"]") +
                                         check("is lost", "expect = \"lost\"\nseed = 7") +
                                         "[[check]]\nname = \"nowhere\"\nmap = \"ovla\"\n");
  const Ended ended = robosim_command({"test"}, folder / "Greets");
  EXPECT_EQ(ended.status, 2) << ended.err;
  EXPECT_EQ(
      ended.out,
      "passed  greets     oval · uno5  reached after 0.05 s\n"
      "FAILED  asks back  oval · uno5  reached after 0.05 s\n"
      "        why: the sketch did not send “how are you” over its serial port after “hello”\n"
      "        see: robosim run . --map oval --goal none --for 50ms --seed 1 --view\n"
      "FAILED  is lost    oval · uno5  reached after 0.05 s\n"
      "        why: reached (expected: lost): 0.05 s of simulated time went by without a failure.\n"
      "        see: robosim run . --map oval --goal none --for 50ms --seed 7 --view\n"
      "ERROR   nowhere\n"
      "        why: checks.toml:20:1: there is no map “ovla”; did you mean oval? There are a, b, blocked, "
      "c, city, d, dashed, e, f, figure8, island, oval, tight and warehouse (a name with / or . is a "
      "path)\n"
      "1 of 4 checks passed\n");
}

TEST(CliTest, ItsStatusIsThatOfTheWorstCheck) {
  const Folder folder;
  folder.write("Greets/Greets.ino", kGreets);
  const auto status = [&](const std::string& checks) {
    folder.write("Greets/checks.toml", checks);
    return robosim_command({"test"}, folder / "Greets").status;
  };
  const std::string late = "[[check]]\nname = \"late\"\ngoal = \"laps:1\"\nmap = \"oval\"\nfor = \"50ms\"\n";
  EXPECT_EQ(status(check("a", "")), 0);
  EXPECT_EQ(status(check("a", "") + late), 4);
  EXPECT_EQ(status(check("a", "time_s = { max = 0 }") + late), 1);
  EXPECT_EQ(status(check("a", "robot = \"nobody\"")), 2);
  EXPECT_EQ(status("[[check]]\n"), 2);
}

TEST(CliTest, OfManySketchesEachHasALineAndNoneStopsTheOthers) {
  const Folder folder;
  folder.write("pupils/anna/anna.ino", kGreets);
  folder.write("pupils/ben/ben.ino", "void setup() {}\nvoid loop() { delay(1) }\n");
  folder.write("pupils/cleo/cleo.ino", "void setup() {}\nvoid loop() { delay(1); }\n");
  folder.write("pupils/dan/notes.txt", "no sketch yet");
  folder.write("class.toml", check("greets", "serial = \"hello\"") + check("runs", ""));
  const Words words{"test",        "pupils/anna/", "pupils/ben/", "pupils/cleo/",
                    "pupils/dan/", "--checks",     "class.toml"};
  const Ended ended = robosim_command(words, folder.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(
      ended.out,
      MatchesRegex(
          "pupils/anna  passed  2 of 2\n"
          "pupils/ben   ERROR   ben.ino:2:[^\n]*error: expected[^\n]*\n"
          "pupils/cleo  FAILED  1 of 2  greets: the sketch did not send “hello” over its serial port\n"
          "pupils/dan   ERROR   pupils/dan/: expected a sketch, got a folder[^\n]*\n"
          "1 of 4 sketches passed all checks\n"));
}

TEST(CliTest, AMissingLibraryIsAnErrorOfItsSketchAlone) {
  const Folder folder;
  folder.write("anna/anna.ino", kGreets);
  folder.write("ben/ben.ino", "#include <Gears.h>\n" + std::string(kGreets));
  folder.write("shared/Gears/Gears.h", "#pragma once\n");
  folder.write("class.toml", check("greets", "serial = \"hello\"") + check("runs", ""));
  Words words{"test", "anna", "ben", "--checks", "class.toml"};
  Ended ended = robosim_command(words, folder.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.out, MatchesRegex("anna  passed  2 of 2\n"
                                      "ben   ERROR   ben.ino:1:10: no such header Gears.h [^\n]*\n"
                                      "1 of 2 sketches passed all checks\n"));
  words.insert(words.end(), {"--libraries", "shared"});
  ended = robosim_command(words, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("2 of 2 sketches passed all checks\n"));
}

TEST(CliTest, SaysTheSameForAnyNumberOfJobs) {
  const Folder folder;
  const std::string sketch = ROBOSIM_TEST_SKETCHES "/FailsByChance";
  folder.write(
      "checks.toml",
      check("some fail", "seeds = \"1..8\"\nmin-rate = 0.9\nrobot = \"uno5\"") +
          check("half is enough", "seeds = \"1..8\"\nmin-rate = 0.1\nrobot = \"uno5\"") +
          check("stops early", "seeds = \"1..8\"\nstop-early = true\nmin-rate = 1\nrobot = \"uno5\""));
  std::vector<Ended> ended;
  std::vector<std::string> junit;
  for (const char* jobs : {"1", "3"}) {
    ended.push_back(
        robosim_command({"test", sketch, "--checks", "checks.toml", "--jobs", jobs, "--junit", "results.xml"},
                        folder.path()));
    junit.push_back(read_file(folder / "results.xml"));
  }
  EXPECT_EQ(ended[0].status, 1) << ended[0].err;
  EXPECT_THAT(ended[0].out, HasSubstr("seeds 1..8"));
  EXPECT_THAT(ended[0].out, HasSubstr("; min-rate = 0.9 needs 8 of 8; seed "));
  EXPECT_THAT(ended[0].out, HasSubstr("passed  half is enough"));
  EXPECT_EQ(ended[1].out, ended[0].out);
  EXPECT_EQ(junit[1], junit[0]);
}

TEST(CliTest, WritesJunitWithTheFigures) {
  const Folder folder;
  folder.write("Greets/Greets.ino", kGreets);
  folder.write("Greets/checks.toml", check("a < b", "") + check("fails", "distance_m = { min = 1 }"));
  robosim_command({"test", "--junit", "results.xml"}, folder / "Greets");
  const std::string xml = read_file(folder / "Greets/results.xml");
  EXPECT_THAT(xml, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"robosim\" "
                              "tests=\"2\" failures=\"1\" errors=\"0\" time=\"0.100\">\n"
                              "  <testsuite name=\"Greets\" tests=\"2\""));
  EXPECT_THAT(xml,
              HasSubstr("<testcase classname=\"Greets\" name=\"a &lt; b\" file=\"checks.toml\" line=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<property name=\"collisions\" value=\"0\"/>"));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"distance_m: expected at least 1, got 0\">"));
  EXPECT_THAT(xml, HasSubstr("</failure>\n      <system-out>hello\n</system-out>\n    </testcase>"));
  EXPECT_EQ(xml.find("<system-out>"), xml.rfind("<system-out>")) << "only failures have output";

  EXPECT_EQ(robosim_command({"report", "results.xml"}, folder / "Greets").out,
            "report.html is written, and a replay next to it; open it in a browser\n");
  EXPECT_THAT(read_file(folder / "Greets/report.html"),
              AllOf(HasSubstr("<a href=\"report-runs/Greets-fails.html\">fails</a>"),
                    HasSubstr("never left the line.")));
  folder.write("Greets/Greets.ino", "void setup() {}\nvoid loop() { delay(1); }\n");
  EXPECT_EQ(robosim_command({"report", "results.xml"}, folder / "Greets").out,
            "report.html is written; open it in a browser\n");
  EXPECT_THAT(read_file(folder / "Greets/report.html"), HasSubstr("1 of the runs had another result"));
}

/// Sets an environment variable. The destructor removes the variable.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

TEST(CliTest, OnGithubItNotesFailuresAtTheirLinesAndAddsToTheSummary) {
  const Folder folder;
  folder.write("Greets/Greets.ino", kGreets);
  folder.write("Greets/checks.toml", check("works", "") + check("50%", "expect = \"lost\""));
  folder.write("summary.md", "before\n");
  const Variable actions("GITHUB_ACTIONS", "true");
  const Variable workspace("GITHUB_WORKSPACE", folder.path());
  const Variable summary("GITHUB_STEP_SUMMARY", folder / "summary.md");
  const Ended failed = robosim_command({"test"}, folder / "Greets");
  EXPECT_THAT(failed.out,
              HasSubstr("\n::error file=Greets/checks.toml,line=7,title=Greets%3A 50%25::reached "));
  EXPECT_THAT(read_file(folder / "summary.md"),
              AllOf(StartsWith("before\n| sketch |"),
                    HasSubstr("\n| Greets | works | oval · uno5 | ✅ passed |  |\n| Greets | 50% | ")));

  folder.write("Greets/Greets.ino", "void setup() {}\nvoid loop() { x = 1; }\n");
  const Ended broken = robosim_command({"test"}, folder / "Greets");
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.out, HasSubstr("::error file=Greets/Greets.ino,line=2,title=Greets::"));
  EXPECT_THAT(broken.err, HasSubstr("Greets.ino:2"));
}

TEST(CliNew, MakesAProjectThatPasses) {
  const Folder folder;
  const Ended made = robosim_command({"new", "demo"}, folder.path());
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, AllOf(HasSubstr("demo.ino"), HasSubstr("test/line_test.cpp"),
                              EndsWith("next: cd demo && robosim test\n")));
  const Ended tested = robosim_command({"test"}, folder / "demo");
  EXPECT_EQ(tested.status, 0) << tested.out << tested.err;
  EXPECT_THAT(tested.err, IsEmpty()) << "no compiler warning either";
  EXPECT_THAT(read_file(folder / "demo/README.md"), AllOf(StartsWith("# demo\n"), Not(HasSubstr("NAME"))));
}

TEST(CliNew, OverwritesNothingAndRefusesWhatIsNoNameOfASketch) {
  const Folder folder;
  folder.write("mine/mine.ino", "// mine\n");
  const Ended taken = robosim_command({"new", "mine"}, folder.path());
  EXPECT_EQ(taken.status, 2);
  EXPECT_THAT(taken.err, HasSubstr("“mine” exists already; nothing was changed"));
  EXPECT_EQ(read_file(folder / "mine/mine.ino"), "// mine\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "mine/checks.toml"));
  for (const char* name : {"a/b", "..", ".x", "a b", "Zähler", "-x", "x.", ""}) {
    const Ended refused = robosim_command({"new", name}, folder.path());
    EXPECT_EQ(refused.status, 2) << name;
  }
}

}  // namespace cli_test_test
}  // namespace robosim::test
