#include "sim/build/coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/archive.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::build {
namespace coverage_test {

namespace fs = std::filesystem;

FileCoverage file(const char* name, std::map<int, std::uint64_t> lines) {
  return {name, std::move(lines), {{"turn(int, int)", {3, 2}}, {"loop()", {9, 0}}}};
}

TEST(Coverage, SummaryNamesTheLinesThatNeverRanAndLinesWithoutCodeDoNotPartThem) {
  EXPECT_EQ(summary({file("/a/S.ino", {{1, 5}, {2, 0}, {3, 0}, {6, 0}, {7, 1}, {9, 0}, {30, 2}})}),
            "3 of 7 lines of S.ino ran; never ran: 2-6, 9\n");
  EXPECT_EQ(summary({file("/a/S.ino", {{1, 5}}), file("/a/b.cpp", {{2, 0}})}),
            "1 of 1 lines of S.ino ran\n0 of 1 lines of b.cpp ran; never ran: 2\n");
}

TEST(Coverage, AddsUpLineByLine) {
  Coverage sum = {file("/a/S.ino", {{1, 5}, {2, 0}})};
  add(sum, {file("/a/A.ino", {{7, 1}}), file("/a/S.ino", {{1, 2}, {2, 3}})});
  ASSERT_EQ(sum.size(), 2u);
  EXPECT_EQ(sum[0].file, "/a/A.ino");
  EXPECT_EQ(sum[1].lines, (std::map<int, std::uint64_t>{{1, 7}, {2, 3}}));
  EXPECT_EQ(sum[1].functions.at("turn(int, int)").calls, 4u);
}

TEST(Coverage, ReadsBackTheTracefileItWrites) {
  const Coverage coverage = {file("/A b/S.ino", {{1, 5}, {2, 0}}),
                             file("/a/b.cpp", {{2, 18446744073709551615u}})};
  const std::string text = to_info(coverage);
  EXPECT_EQ(text.substr(0, text.find("SF:/a/b.cpp")),
            "TN:\nSF:/A b/S.ino\nFN:9,loop()\nFN:3,turn(int, int)\nFNDA:0,loop()\nFNDA:2,turn(int, "
            "int)\nFNF:2\nFNH:1\n"
            "DA:1,5\nDA:2,0\nLF:2\nLH:1\nend_of_record\n");
  EXPECT_EQ(parse_info(text, "x.info"), coverage);
  EXPECT_THROW(parse_info("TN:\nDA:1,2\n", "x.info"), InputError);
  EXPECT_THROW(parse_info("SF:/a\nDA:one,2\n", "x.info"), InputError);
}

class CoverageFolder : public testing::Test {
 protected:
  CoverageFolder() {
    fs::create_directories(folder_ / "S");
    write_file(folder_ / "S/S.ino", "void setup() {}\nvoid loop() {}\n");
    image_.name = "S";
    image_.sketch_sha256 = "0123456789abcdef";
  }

  std::uint64_t count_after(const std::string& run) {
    const Coverage sum = add_to_folder(folder_ / "out", {folder_ / "S", *find_board("uno")}, image_,
                                       {file("/a/S.ino", {{1, 5}})}, run);
    EXPECT_EQ(parse_info(read_file(folder_ / "out/coverage.info"), ""), sum);
    return sum.at(0).lines.at(1);
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
  Image image_;
};

TEST_F(CoverageFolder, TakesNoFileOfCountersThatNoSourceHas) {
  // Robosim reads the names of counter files from the sketch's memory, so the sketch can forge them.
  image_.notes = folder_ / "S.notes";
  write_file(image_.notes, pack({}));
  const std::string counters = pack({{"/x/", ""}, {"/x/..", ""}, {".", ""}, {"../S.gcda", ""}, {"", ""}});
  EXPECT_TRUE(read_coverage({folder_ / "S", *find_board("uno")}, image_, counters).empty());
}

TEST_F(CoverageFolder, ARunCountsOnceHoweverOftenItIsMade) {
  EXPECT_EQ(count_after("seed 1"), 5u);
  EXPECT_EQ(count_after("seed 2"), 10u);
  EXPECT_EQ(count_after("seed 1"), 10u);
}

TEST_F(CoverageFolder, RunsOfAnOlderVersionOfTheSketchAreForgotten) {
  EXPECT_EQ(count_after("seed 1"), 5u);
  image_.sketch_sha256 = "fedcba9876543210";
  EXPECT_EQ(count_after("seed 2"), 5u);
}

}  // namespace coverage_test
}  // namespace robosim::build
