// `robosim run --record` and `--plot`, and `robosim replay`.

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
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// The compiler decides where basic blocks of a sketch begin: see golden_test.cpp.
constexpr const char* kCompiler = "gcc 12.2.0 x86_64-linux-gnu";

TEST(Record, APageHoldsTheSameFiguresAsTheTable) {
  const Folder folder;
  const std::vector<std::string> words{"run", "PidFollower", "--map", "tight", "--for", "3s", "--json"};
  std::vector<std::string> recorded = words;
  for (const char* file : {"run.html", "run.csv", "run.rec", "run.vcd", "run.svg"}) {
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
  EXPECT_EQ(replayed.out.substr(0, 400), ran.out.substr(0, 400)) << "the same picture";
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

TEST(Record, APlotIsAPictureOrIsRefused) {
  const Ended ended = robosim_command({"run", "PidFollower", "--plot", "x.csv"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("--plot"), HasSubstr("must be .svg")));
}

TEST(Record, PicturesInTheDocsAreWhatTheCommandDraws) {
  const build::Image image = build::build({build::find_sketch("PidFollower"), *find_board("uno")});
  if (image.compiler != kCompiler)
    GTEST_SKIP() << "drawn with " << kCompiler << ", this is " << image.compiler;
  const Folder folder;
  struct Drawn {
    const char* picture;
    std::filesystem::path where;  ///< no path of this machine gets into the picture
    std::vector<std::string> run;
  };
  for (const Drawn& one :
       {Drawn{"tight.svg", folder.path(), {"PidFollower", "--map", "tight"}},
        Drawn{"robotracer.svg", ROBOSIM_SAMPLES "/Robotracer", {".", "--map", "course.map"}},
        Drawn{"rescue-line.svg", ROBOSIM_SAMPLES "/RescueLine", {".", "--map", "course.map"}},
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
        << "write " << picture << " anew: ROBOSIM_WRITE_DOCS=1 with this test";
  }
}

}  // namespace
}  // namespace robosim::test
