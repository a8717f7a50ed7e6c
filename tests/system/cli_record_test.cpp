// Tests `robosim run --record` and `--plot`, and `robosim replay`.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "sim/base/csv.h"
#include "sim/record/recording.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_record_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// The trace depends on the compiler, which decides where a sketch's basic blocks begin: see golden_test.cpp.
constexpr const char* kCompiler = "gcc 12.2.0 x86_64-linux-gnu";

TEST(Record, APageHoldsTheSameFiguresAsTheTable) {
  const Folder folder;
  const std::vector<std::string> words{"run", "PidFollower", "--map", "tight", "--for", "3s", "--json"};
  std::vector<std::string> recorded = words;
  for (const char* file : {"run.html", "run.csv", "run.rec", "run.vcd", "run.svg", "run.perfetto.json"}) {
    recorded.push_back("--record");
    recorded.push_back(file);
  }
  const Ended plain = robosim_command(words, folder.path());
  const Ended ended = robosim_command(recorded, folder.path());
  EXPECT_EQ(ended.out, plain.out) << "recording changes nothing";
  const record::Recording page = record::Recording::read(folder / "run.html");
  const auto samples = page.stream("samples");
  ASSERT_EQ(samples.size(), 10 + page.header().started.readings.size());

  std::istringstream table(read_file(folder / "run.csv"));
  std::string line;
  std::getline(table, line);
  std::size_t row = 0;
  for (; std::getline(table, line); ++row) {
    const auto fields = csv_fields(line);
    ASSERT_TRUE(fields && row < samples[0].size());
    const auto at = [&](std::size_t i) { return std::atof((*fields)[i].c_str()); };
    EXPECT_EQ(samples[0][row], at(0));
    EXPECT_NEAR(samples[1][row], at(1), 0.0051);
    EXPECT_NEAR(samples[2][row], at(2), 0.0051);
    EXPECT_NEAR(samples[3][row], at(3), 0.000051);
    EXPECT_NEAR(samples[5][row], at(5), 0.0051);
    for (std::size_t i = 8; i < fields->size(); ++i) EXPECT_NEAR(samples[i + 2][row], at(i), 0.00051);
  }
  EXPECT_EQ(row, 301u);
  EXPECT_EQ(samples[0].size(), row);
  EXPECT_EQ(record::Recording::read(folder / "run.rec").stream("samples"), samples);
}

TEST(Record, TheReplayEndsAsTheRunDid) {
  const Folder folder;
  const Ended ran =
      robosim_command({"run", "PidFollower", "--map", "oval", "--record", "run.html"}, folder.path());
  const Ended replayed = robosim_command({"replay", "run.html"}, folder.path());
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_THAT(replayed.out, AllOf(HasSubstr("PidFollower · uno5 on oval · goal laps:1"),
                                  HasSubstr("reached: The goal laps:1 was reached after 8.5")));
  EXPECT_EQ(replayed.out.substr(0, 400), ran.out.substr(0, 400)) << "equal pictures";
}

TEST(Record, WhatIsNoRecordingIsRefusedInOneSentence) {
  const Folder folder;
  write_file(folder / "x.html", "<!doctype html><p>hello");
  write_file(folder / "x.rec", "robosim.rec/1\nnothing that zlib wrote");
  for (const char* file : {"x.html", "x.rec", "none.rec"}) {
    const Ended ended = robosim_command({"replay", file}, folder.path());
    EXPECT_EQ(ended.status, 2) << file;
    EXPECT_THAT(ended.err, AllOf(StartsWith("robosim: "), HasSubstr(file)));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  }
}

TEST(Record, ARunIsHeldAgainstAnotherAndBothAreOnOnePage) {
  const Folder folder;
  const auto run = [&](const char* seed, const char* file) {
    robosim_command({"run", "PidFollower", "--map", "tight", "--for", "3s", "--seed", seed, "--record", file},
                    folder.path());
  };
  run("1", "one.rec");
  run("2", "two.html");
  const Ended ended =
      robosim_command({"replay", "one.rec", "--over", "two.html", "--record", "both.html"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("over it: two.html: PidFollower on tight, seed 2, host: timeout after 3.00 s"),
                    HasSubstr("apart:   1 mm at 0."), HasSubstr("until 3.00 s")));
  EXPECT_EQ(record::Recording::read(folder / "both.html").header().result.seed, 1u);
  EXPECT_THAT(robosim_command({"replay", "one.rec", "--over", "one.rec"}, folder.path()).out,
              HasSubstr("apart:   never 1 mm, in 3.00 s"));

  write_file(folder / "real.csv", "t_ms,x_mm,y_mm\n0,1,2\n10,one,2\n");
  const Ended bad = robosim_command({"replay", "one.rec", "--over", "real.csv"}, folder.path());
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("real.csv:3: time, x and y: expected numbers"));
  const Ended ending = robosim_command({"replay", "one.rec", "--record", "x.vcd"}, folder.path());
  EXPECT_EQ(ending.status, 2);
  EXPECT_THAT(ending.err, HasSubstr("x.vcd: expected a name that ends in .html, .rec or .perfetto.json"));
}

TEST(Record, APngIsThePictureInPixels) {
  const Folder folder;
  const std::vector<std::string> words{"run",   "PidFollower", "--map",  "tight",
                                       "--for", "1s",          "--plot", "run.png"};
  if (std::system("command -v rsvg-convert >/dev/null 2>&1") != 0) {
    const Ended ended = robosim_command(words, folder.path());
    EXPECT_EQ(ended.status, 5);
    EXPECT_THAT(ended.err, HasSubstr("run.png: rsvg-convert, which paints .png, is missing; install it (sudo "
                                     "apt install librsvg2-bin)"));
    EXPECT_FALSE(std::filesystem::exists(folder / "run.png"));
    return;
  }
  EXPECT_EQ(robosim_command(words, folder.path()).status, 4);
  const std::string png = read_file(folder / "run.png");
  ASSERT_THAT(png, StartsWith("\x89PNG\r\n\x1A\n"));
  const auto number = [&](std::size_t at) {
    return static_cast<unsigned char>(png[at + 2]) << 8 | static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(number(16), 1920) << "twice the width of the .svg";
  EXPECT_GT(number(20), 1000);
}

TEST(Record, APlotIsAPictureOrIsRefused) {
  const Ended ended = robosim_command({"run", "PidFollower", "--plot", "x.csv"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("--plot"), HasSubstr("expected a name that ends in .svg or .png")));
}

TEST(Record, PicturesInTheDocsAreWhatTheCommandDraws) {
  const build::Image image = build::build({build::find_sketch("PidFollower"), *find_board("uno")});
  if (image.compiler != kCompiler)
    GTEST_SKIP() << "drawn with " << kCompiler << ", but this is " << image.compiler;
  const Folder folder;
  struct Drawn {
    const char* picture;
    std::filesystem::path where;  ///< working directory: keeps paths of this machine out of the picture
    std::vector<std::string> run;
  };
  for (const Drawn& one :
       {Drawn{"tight.svg", folder.path(), {"PidFollower", "--map", "tight"}},
        Drawn{"robotracer.svg", ROBOSIM_SAMPLES "/Robotracer", {".", "--map", "course.map"}},
        Drawn{"rescue-line.svg", ROBOSIM_SAMPLES "/RescueLine", {".", "--map", "course.map"}},
        Drawn{"rescue-entry.svg",
              ROBOSIM_SAMPLES "/RescueEntry",
              {".", "--map", "course.map", "--for", "120s"}},
        Drawn{"rescue-hills.svg",
              ROBOSIM_SAMPLES "/RescueHills",
              {".", "--map", "course.map", "--for", "120s"}},
        Drawn{"ukmars.svg", ROBOSIM_SAMPLES "/Ukmars", {".", "--map", "course.map"}},
        Drawn{"drag-race.svg",
              ROBOSIM_SAMPLES "/DragRacer",
              {".", "--map", "course.map", "--script", "signal.txt"}},
        Drawn{"dprg.svg", ROBOSIM_SAMPLES "/DprgLine", {".", "--map", "course.map"}},
        Drawn{"line-maze.svg",
              ROBOSIM_SAMPLES "/LineMaze",
              {".", "--map", "lvbots.map", "--script", "tries.txt", "--for", "60s"}}}) {
    const std::filesystem::path picture = std::filesystem::path(ROBOSIM_PICTURES) / one.picture;
    std::vector<std::string> words{"run", "--plot", (folder / one.picture).string()};
    words.insert(words.end(), one.run.begin(), one.run.end());
    const Ended ended = robosim_command(words, one.where);
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::string drawn = read_file(folder / one.picture);
    if (::getenv("ROBOSIM_WRITE_DOCS")) write_file(picture, drawn);
    EXPECT_TRUE(drawn == read_file(picture))
        << "regenerate " << picture << ": run this test with ROBOSIM_WRITE_DOCS=1";
  }
}

}  // namespace cli_record_test
}  // namespace robosim::test
