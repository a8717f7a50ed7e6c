#include "sim/record/record_csv.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::record {
namespace record_csv_test {

using ::testing::HasSubstr;

wire::Started started(std::vector<std::string> readings) {
  wire::Started event;
  event.readings = std::move(readings);
  return event;
}

const test::TemporaryFolder& tables() {
  static const test::TemporaryFolder folder;
  return folder;
}

const std::filesystem::path& path() {
  static const std::filesystem::path path = tables().path() / "x.csv";
  return path;
}

/// Finishes the table. Returns the file's content.
std::string text_of(CsvRecorder& record) {
  record.finish({});
  return read_file(path());
}

TEST(CsvRecorder, HasOneHeaderRowWithUnitsAndAColumnForEachReading) {
  CsvRecorder record(path());
  record.add(started({"S1", "S2"}));
  record.add(wire::Sample{10000, 1352.1, 248.9, 0.01, 310.0, 1.25, 0.6, -0.5, {0.0, 0.9}});
  record.add(wire::Note{1, "not recorded"});
  EXPECT_EQ(text_of(record),
            "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1,S2\n"
            "10000,1352.1,248.9,0.01,310,1.25,0.6,-0.5,0,0.9\n");
}

TEST(CsvRecorder, QuotesNamesThatWouldBreakTheTable) {
  CsvRecorder record(path());
  record.add(started({"a,b", "c\"d"}));
  EXPECT_THAT(text_of(record), HasSubstr(",\"a,b\",\"c\"\"d\"\n"));
}

TEST(CsvRecorder, IsOnTheDiskOnlyOnceItIsSavedHoweverLongItIs) {
  const std::filesystem::path file = tables().path() / "long.csv";
  std::string rows;
  {
    CsvRecorder record(file), given_up(file);
    for (CsvRecorder* one : {&record, &given_up}) one->add(started({"S1"}));
    for (int i = 0; i < 20'000; ++i) {
      wire::Sample sample{i, 0.1 * i, 2.5, 0, 0, 0, 0, 0, {i % 3 == 0 ? 0.0 : 0.25}};
      record.add(sample);
      given_up.add(sample);
      rows += std::to_string(i) + fmt::format(",{},2.5,0,0,0,0,0,{}\n", 0.1 * i, i % 3 == 0 ? "0" : "0.25");
    }
    EXPECT_THAT(std::distance(std::filesystem::directory_iterator(tables().path()), {}), ::testing::Le(1));
    EXPECT_FALSE(std::filesystem::exists(file));
    record.finish({});
  }
  EXPECT_EQ(read_file(file), "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1\n" + rows);
}

TEST(CsvRecorder, SaysAtTheEndThatItCannotBeWritten) {
  const std::filesystem::path file = tables().path() / "missing" / "x.csv";
  CsvRecorder record(file);
  record.add(started({"S1"}));
  for (int i = 0; i < 20'000; ++i) record.add(wire::Sample{i, 0.1 * i});
  try {
    record.finish({});
    FAIL() << "there is no such folder";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot be written"));
  }
}

TEST(CsvRecorder, HasTheReadingsOfAllRobotsInTheHeaderThoughOneBeginsBehindTheOthersFirstRow) {
  RecordedRun run;
  run.robots = {{"A", "", "", "", {}}, {"B", "", "", "", {}}};
  CsvRecorder record(path());
  record.begin(run);
  wire::Started second = started({"T1"});
  second.agent = 1;
  wire::Sample row, other;
  row.readings = {0.5};
  other.readings = {1};
  other.agent = 1;
  record.add(started({"S1"}));
  record.add(row);
  record.add(second);
  record.add(other);
  EXPECT_EQ(text_of(record),
            "t_us,robot,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1,T1\n"
            "0,A,0,0,0,0,0,0,0,0.5,\n0,B,0,0,0,0,0,0,0,,1\n");
}

// Only a faulty runner sends samples of a robot that has not started. These samples must not crash the
// command.
TEST(CsvRecorder, ARobotThatHasNotBegunHasNoReadingsAndOneThatCannotBeNoRow) {
  CsvRecorder record(path());
  wire::Sample sample;
  sample.agent = 3;
  sample.readings = {0.5};
  record.add(sample);
  sample.agent = 1'000'000'000;
  record.add(sample);
  EXPECT_EQ(text_of(record),
            "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right\n0,0,0,0,0,0,0,0\n");
}

TEST(CsvRecorder, OtherEndingsAreRefusedNamingTheOnesThatExist) {
  EXPECT_NO_THROW(make_recorder("a/b.csv"));
  try {
    make_recorder("a.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("expected a name that ends in .csv, .vcd, .html, .rec, .perfetto.json, .svg or .png"));
  }
}

}  // namespace record_csv_test
}  // namespace robosim::record
