// Tests `robosim sweep`, as a user runs it, with very short runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/record/recording.h"
#include "tests/system/json_of.h"
#include "tests/system/on_terminal.h"

namespace robosim::test {
namespace cli_sweep_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string kFailsByChance = ROBOSIM_TEST_SKETCHES "/FailsByChance";

using Words = std::vector<std::string>;

/// Returns a sweep over two maps. Its runs fail with some seeds.
Words sweep_words(const Words& more) {
  Words words{"sweep",   kFailsByChance, "--map",  "oval", "tight", "--robot", "uno5",
              "--seeds", "1..8",         "--goal", "none", "--for", "50ms"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

long count_of(const std::string& text, const std::string& part) {
  long count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(CliSweep, GivesTheSameBytesForAnyNumberOfJobs) {
  const Folder folder;
  std::vector<std::string> tables, reports, json;
  for (const char* jobs : {"1", "2", "5"}) {
    const std::string file = std::string("jobs") + jobs + ".csv";
    const Ended ended =
        robosim_command(sweep_words({"--jobs", jobs, "--csv", file, "--min-rate", "0.5"}), folder.path());
    tables.push_back(read_file(folder / file));
    reports.push_back(ended.out);
    json.push_back(robosim_command(sweep_words({"--jobs", jobs, "--json"}), folder.path()).out);
  }
  EXPECT_THAT(lines_of(tables[0]), SizeIs(1 + 16));
  EXPECT_GT(count_of(tables[0], ",crashed,"), 0);
  EXPECT_GT(count_of(tables[0], ",reached,"), 0);
  for (const std::size_t i : {1u, 2u}) {
    EXPECT_EQ(tables[i], tables[0]);
    EXPECT_EQ(reports[i], reports[0]);
    EXPECT_EQ(json[i], json[0]);
  }
}

TEST(CliSweep, ASketchThatDoesNotCompileIsLeftOutAndNamed) {
  const Folder folder;
  folder.write("Good/Good.ino", "void setup() {}\nvoid loop() { delay(1); }\n");
  folder.write("Wrong/Wrong.ino", "void setup() {}\nvoid loop() { delay(1) }\n");
  folder.write("Needy/Needy.ino", "#include <Gears.h>\nvoid setup() {}\nvoid loop() {}\n");
  const auto sweep = [&](std::vector<std::string> sketches) {
    sketches.insert(sketches.begin(), "sweep");
    sketches.insert(sketches.end(), {"--seeds", "1..2", "--for", "10ms", "--goal", "none"});
    return robosim_command(sketches, folder.path());
  };
  const Ended ended = sweep({"Wrong", "Good", "Needy"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(
      ended.err,
      AllOf(HasSubstr("robosim: Wrong does not compile, and is left out: Wrong.ino:2:23: error: expected"),
            HasSubstr("robosim: Needy does not compile, and is left out: Needy.ino:1:10: no such")));
  EXPECT_THAT(ended.out, AllOf(HasSubstr("Good "), Not(HasSubstr("Wrong"))));
  EXPECT_THAT(sweep({"Wrong", "Needy"}).err, HasSubstr("Needy.ino:1:10: no such header Gears.h"))
      << "no sketch compiles";
}

TEST(CliSweep, AFailingSeedComesWithTheCommandThatMakesItAgain) {
  const Folder folder;
  const Ended sweep = robosim_command(sweep_words({"--csv", "a.csv"}), folder.path());
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  const auto at = sweep.out.find("    robosim run ");
  ASSERT_NE(at, std::string::npos) << sweep.out;
  std::istringstream command(sweep.out.substr(at, sweep.out.find('\n', at) - at));
  Words words;
  for (std::string word; command >> word;) words.push_back(word);
  words.erase(words.begin());
  words.push_back("--json");
  const Ended replay = robosim_command(words, folder.path());
  EXPECT_EQ(replay.status, 1) << replay.err;
  const nlohmann::json result = json_of(replay);
  EXPECT_EQ(result["verdict"], "crashed");
  EXPECT_THAT(lines_of(read_file(folder / "a.csv")),
              Contains(ContainsRegex(",crashed,.*," + result["trace_hash"].get<std::string>() + ",")));
}

TEST(CliSweep, ResumeGivesTheFileThatAnUninterruptedSweepGives) {
  const Folder folder;
  robosim_command(sweep_words({"--csv", "whole.csv"}), folder.path());
  const std::string whole = read_file(folder / "whole.csv");
  const auto third_row = whole.find("host,3,");
  for (const std::size_t kept : {std::size_t{10}, third_row + 30, whole.size() - 1, whole.size()}) {
    folder.write("cut.csv", whole.substr(0, kept));
    const Ended ended = robosim_command(sweep_words({"--csv", "cut.csv", "--resume"}), folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(read_file(folder / "cut.csv"), whole) << kept;
  }
  robosim_command(sweep_words({"--csv", "new.csv", "--resume"}), folder.path());
  EXPECT_EQ(read_file(folder / "new.csv"), whole);
}

TEST(CliSweep, ResumeMakesOnlyTheRunsThatAreMissing) {
  const Folder folder;
  Words few = sweep_words({"--csv", "a.csv"}), all = few;
  std::replace(few.begin(), few.end(), std::string("1..8"), std::string("3..5"));
  robosim_command(few, folder.path());
  std::string text = read_file(folder / "a.csv");
  // Makes a row as older versions wrote it: without the checksum, the last part of the row's inputs.
  const auto row = text.find("host,4,"), end = text.find("\n", row);
  text.insert(end, " (as found)");
  const auto checksum = text.rfind('-', text.rfind(',', end));
  text.erase(checksum, text.find(',', checksum) - checksum);
  folder.write("a.csv", text);
  all.push_back("--resume");
  const Ended ended = robosim_command(all, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  const auto lines = lines_of(read_file(folder / "a.csv"));
  ASSERT_THAT(lines, SizeIs(17));
  EXPECT_THAT(lines[4], HasSubstr("(as found)"));
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_THAT(lines[i + 1], ContainsRegex(std::string(i < 8 ? "oval" : "tight") + ",uno5,host," +
                                            std::to_string(i % 8 + 1) + ","));
  }
}

TEST(CliSweep, AFileOfOtherRunsIsLeftAsItIs) {
  const Folder folder;
  folder.write("mine/mine.ino", "void setup() {}\nvoid loop() {}\n");
  folder.write("a.map", "_____\n_S.G_\n_____\n");
  const Words words{"sweep", "mine/mine.ino", "--map", "a.map", "--for",
                    "10ms",  "--seeds",       "1..3",  "--csv", "a.csv"};
  robosim_command(words, folder.path());
  std::string before = read_file(folder / "a.csv");
  const auto refused = [&](Words changed, const std::string& why) {
    const Ended ended = robosim_command(std::move(changed), folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr(why));
    EXPECT_EQ(count_of(ended.err.substr(ended.err.rfind("robosim: a.csv")), "\n"), 1);
    EXPECT_EQ(read_file(folder / "a.csv"), before);
  };
  refused(words, "a.csv: exists already; --resume continues it");
  Words again = words;
  again.push_back("--resume");
  Words changed = again;
  changed[5] = "20ms";
  refused(changed, "a.csv:2: an option, or the version of Robosim, has changed");
  changed = again;
  changed[7] = "2..3";
  refused(changed, "a.csv:2: this run (mine/mine.ino on a.map with uno5, target host, seed 1) is not part");
  folder.write("a.map", "_____\n_S.._\n_____\n");
  refused(again, "a.csv:2: the map has changed");
  folder.write("a.map", "_____\n_S.G_\n_____\n");
  folder.write("mine/mine.ino", "void setup() { delay(1); }\nvoid loop() {}\n");
  refused(again, "a.csv:2: the sketch's image has changed");
  before = "the only copy of my thesis";
  folder.write("a.csv", before);
  refused(again, "a.csv:1: expected the header of a sweep's table");
}

TEST(CliSweep, TablesOfShardsMergeToThatOfOneSweep) {
  const Folder folder;
  const Ended one = robosim_command(sweep_words({"--csv", "one.csv", "--min-rate", "0.1"}), folder.path());
  for (const char* shard : {"1", "2", "3"}) {
    const std::string part = std::string("part") + shard + ".csv";
    const Ended ended =
        robosim_command(sweep_words({"--shard", shard + std::string("/3"), "--csv", part}), folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(lines_of(read_file(folder / part)), SizeIs(AllOf(Ge(1 + 5), Le(1 + 6))));
  }
  const auto merge = [&](const Words& tables, const std::string& file) {
    Words words = sweep_words({"--csv", file, "--min-rate", "0.1", "--merge"});
    words.insert(words.end(), tables.begin(), tables.end());
    return robosim_command(words, folder.path());
  };
  const Ended all = merge({"part3.csv", "part1.csv", "part2.csv"}, "all.csv");
  EXPECT_EQ(all.out, one.out) << all.err;
  EXPECT_EQ(read_file(folder / "all.csv"), read_file(folder / "one.csv"));
  // The merge simulates the runs that no table contains.
  merge({"part3.csv", "part1.csv"}, "more.csv");
  EXPECT_EQ(read_file(folder / "more.csv"), read_file(folder / "one.csv"));

  const Ended twice = merge({"part1.csv", "one.csv"}, "twice.csv");
  EXPECT_EQ(twice.status, 2);
  EXPECT_THAT(twice.err, HasSubstr("two tables have a row of "));
  EXPECT_FALSE(std::filesystem::exists(folder / "twice.csv"));
}

TEST(CliSweep, ARateThatIsNotMetIsExitStatusOne) {
  const Folder folder;
  const auto status = [&](const Words& more) {
    return robosim_command(sweep_words(more), folder.path()).status;
  };
  EXPECT_EQ(status({"--min-rate", "0.1"}), 0);
  EXPECT_EQ(status({"--min-rate", "99%"}), 1);
  EXPECT_EQ(status({"--min-rate", "0.1", "--sure"}), 0);
  EXPECT_EQ(status({"--min-rate", "0.99", "--sure"}), 2);
}

TEST(CliSweep, StoppingEarlyLeavesOutRunsAndNotTheAnswer) {
  const Folder folder;
  std::vector<std::string> tables;
  for (const char* jobs : {"1", "5"}) {
    const std::string file = std::string(jobs) + ".csv";
    const Ended ended = robosim_command(
        sweep_words({"--min-rate", "0.99", "--stop-early", "--jobs", jobs, "--csv", file}), folder.path());
    EXPECT_EQ(ended.status, 1);
    EXPECT_THAT(ended.out, HasSubstr("of 8 runs; the other runs could not change that it is not met"));
    tables.push_back(read_file(folder / file));
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(count_of(tables[0], ",crashed,"), 2);  // the first run of each map
  EXPECT_LT(lines_of(tables[0]).size(), 17u);
}

TEST(CliSweep, JsonIsALineOfTheRunSchemaForEachRun) {
  const Ended sweep = robosim_command(sweep_words({"--json"}));
  const auto lines = lines_of(sweep.out);
  ASSERT_THAT(lines, SizeIs(16));
  for (const std::string& line : lines)
    EXPECT_THAT(line, StartsWith("{\"schema\":\"robosim.run/1\",\"verdict\":\""));
  EXPECT_EQ(nlohmann::json::parse(lines[3])["inputs"]["seed"], 4);
}

TEST(CliSweep, CtrlCKeepsWhatIsFinishedAndResumeGoesOn) {
  const Folder folder;
  const std::string file = (folder / "a.csv").string();
  // With seed 1 the sketch crashes immediately; with seed 2 it runs forever.
  const Words words{"sweep", kFailsByChance, "--map",    "oval",  "--robot", "uno5",    "--goal",
                    "none",  "--for",        "1000000h", "--csv", file,      "--seeds", "1..2"};
  Words json = words;
  json.push_back("--json");
  OnTerminal sweep(json, 100, 30);
  ASSERT_TRUE(sweep.wait_for("\"crashed\"")) << sweep.seen();
  sweep.type("\003");
  EXPECT_TRUE(sweep.wait_for("interrupted; the same command with --resume continues")) << sweep.seen();
  EXPECT_EQ(sweep.finish(), 130);
  const std::string kept = read_file(file);
  EXPECT_THAT(lines_of(kept), SizeIs(2));
  EXPECT_EQ(count_of(kept, ",crashed,"), 1);

  Words again = words;
  again.push_back("--resume");
  OnTerminal resumed(again, 100, 30);
  ASSERT_TRUE(resumed.wait_for("2 runs")) << resumed.seen();
  resumed.signal(SIGKILL);
  resumed.finish();
  EXPECT_EQ(read_file(file), kept);
}

TEST(CliSweep, BadInputIsOneSentence) {
  const auto sentence = [](const Words& more) {
    const Ended ended = robosim_command(sweep_words(more));
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(count_of(ended.err, "\n"), 1) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(sentence({"--start", "0,0,E"}), HasSubstr("is not on a line"));
  EXPECT_THAT(sentence({"--shard", "4/3"}), HasSubstr("--shard: expected PART/PARTS"));
  EXPECT_THAT(sentence({"--shard", "1/3", "--min-rate", "0.9"}), HasSubstr("give it with --merge"));
  EXPECT_THAT(sentence({"--merge", "a.csv"}), HasSubstr("--merge requires --csv"));
  EXPECT_THAT(sentence({"--csv", "/nowhere/a.csv"}), HasSubstr("/nowhere/a.csv: cannot be written"));
}

TEST(Report, MakesTheWorstRunAgainAndLinksItsReplay) {
  const Folder folder;
  const auto command = [&](std::vector<std::string> words) {
    const Ended ended = robosim_command(std::move(words), folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    return ended.out;
  };
  command({"sweep", "PidFollower", "--map", "oval", "--for", "3s", "--seeds", "1..3", "--csv", "runs.csv"});
  EXPECT_EQ(command({"report", "runs.csv"}),
            "report.html is written, and a replay next to it; open it in a browser\n");
  EXPECT_THAT(
      read_file(folder / "report.html"),
      AllOf(HasSubstr("3 runs, 0 reached their goal"), HasSubstr("3 timeout"),
            HasSubstr(
                "<a href=\"report-runs/PidFollower-oval-uno5-host-2.html\">timeout after 1.8 m, seed 2</a>"),
            HasSubstr("The 3 repeated runs never left the line.")));
  const auto replay = record::Recording::read(folder / "report-runs/PidFollower-oval-uno5-host-2.html");
  EXPECT_EQ(replay.header().result.verdict, "timeout");

  // A table by an older Robosim lacks the runs' commands, so `report` needs the sweep's options.
  std::string older =
      std::regex_replace(read_file(folder / "runs.csv"), std::regex("robosim run [^,]*,"), "");
  folder.write("older.csv", older.replace(older.find("command,"), 8, ""));
  EXPECT_EQ(command({"report", "older.csv", "--for", "3s", "--out", "older.html"}),
            "older.html is written, and a replay next to it; open it in a browser\n");
  EXPECT_EQ(command({"report", "older.csv", "--out", "other.html"}),
            "other.html is written; open it in a browser\n");
  EXPECT_THAT(read_file(folder / "other.html"),
              HasSubstr("3 of the runs had another result when they were repeated"));

  // Files next to the sketch are used although no option names them.
  folder.write("Own/Own.ino", "void setup() {}\nvoid loop() {}\n");
  folder.write("Own/robot.toml", "base = \"uno5\"\n");
  folder.write("Own/own.map", "S....\n");
  command({"sweep", "./Own", "--goal", "still", "--for", "50ms", "--seeds", "1..1", "--csv", "own.csv"});
  EXPECT_EQ(command({"report", "own.csv", "--out", "own.html"}),
            "own.html is written, and a replay next to it; open it in a browser\n");
  const Ended ended = robosim_command({"report", "report.html"}, folder.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("report.html:1: this is not valid XML: "));
}

}  // namespace cli_sweep_test
}  // namespace robosim::test
