#include "sim/record/record_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::record {
namespace {

using ::testing::HasSubstr;

wire::Started started(std::vector<std::string> readings) {
  wire::Started event;
  event.readings = std::move(readings);
  return event;
}

TEST(CsvRecorder, HasOneHeaderRowWithUnitsAndAColumnForEachReading) {
  CsvRecorder record("x.csv");
  record.add(started({"S1", "S2"}));
  record.add(wire::Sample{10000, 1352.1, 248.9, 0.01, 310.0, 1.25, 0.6, -0.5, {0.0, 0.9}});
  record.add(wire::Note{1, "not recorded"});
  EXPECT_EQ(record.text(),
            "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1,S2\n"
            "10000,1352.1,248.9,0.01,310,1.25,0.6,-0.5,0,0.9\n");
}

TEST(CsvRecorder, QuotesNamesThatWouldBreakTheTable) {
  CsvRecorder record("x.csv");
  record.add(started({"a,b", "c\"d"}));
  EXPECT_THAT(record.text(), HasSubstr(",\"a,b\",\"c\"\"d\"\n"));
}

TEST(CsvRecorder, IsOnTheDiskOnlyOnceItIsSaved) {
  const auto path =
      std::filesystem::temp_directory_path() / ("robosim-record-" + std::to_string(::getpid()) + ".csv");
  CsvRecorder record(path);
  record.add(started({}));
  EXPECT_FALSE(std::filesystem::exists(path));
  record.finish({});
  EXPECT_EQ(read_file(path), record.text());
  std::filesystem::remove(path);
}

// No runner does so; one that is broken must not take the command down.
TEST(CsvRecorder, ARobotThatHasNotBegunHasNoReadingsAndOneThatCannotBeNoRow) {
  CsvRecorder record("unwritten.csv");
  wire::Sample sample;
  sample.agent = 3;
  sample.readings = {0.5};
  record.add(sample);
  sample.agent = 1'000'000'000;
  record.add(sample);
  EXPECT_EQ(record.text(), "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right\n0,0,0,0,0,0,0,0\n");
}

TEST(CsvRecorder, OtherEndingsAreRefusedNamingTheOnesThatExist) {
  EXPECT_NO_THROW(make_recorder("a/b.csv"));
  try {
    make_recorder("a.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("must be .csv, .vcd, .html, .rec, .perfetto.json, .svg or .png"));
  }
}

}  // namespace
}  // namespace robosim::record
