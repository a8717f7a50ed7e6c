#include "sim/record/record_vcd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::record {
namespace record_vcd_test {

using ::testing::HasSubstr;
using ::testing::Not;

// Returns the identifier that the file declares for a signal.
std::string id_of(const std::string& vcd, const std::string& signal) {
  const std::size_t end = vcd.find(" " + signal + " $end");
  if (end == std::string::npos) return "undeclared";
  const std::size_t begin = vcd.rfind(' ', end - 1) + 1;
  return vcd.substr(begin, end - begin);
}

const std::filesystem::path& waves() {
  static const test::TemporaryFolder folder;
  static const std::filesystem::path path = folder.path() / "x.vcd";
  return path;
}

/// Finishes the file. Returns its content.
std::string text_of(VcdRecorder& record) {
  record.finish({});
  return read_file(waves());
}

class Vcd : public ::testing::Test {
 protected:
  Vcd() {
    RecordedRun run;
    run.robot_info.board.name = "uno";
    record.begin(run);
  }
  VcdRecorder record{waves()};

  static wire::PinChange output(std::int64_t t, const char* pin, bool level) {
    return {t, pin, "output", level, false, level ? 1.0 : 0.0, 0};
  }
};

TEST_F(Vcd, DeclaresEverySignalOfTheBoardBeforeTheFirstChange) {
  const std::string vcd = text_of(record);
  const std::size_t declared = vcd.find("$enddefinitions $end");
  ASSERT_NE(declared, std::string::npos);
  for (const char* signal : {"D0", "D13", "A5", "D5_duty", "D11_tone_hz", "A0_volts", "tx", "rx_flip"})
    EXPECT_LT(vcd.find(std::string(" ") + signal + " $end"), declared) << signal;
  EXPECT_THAT(vcd, Not(HasSubstr("D4_duty"))) << "pin 4 has no PWM";
  EXPECT_THAT(vcd, Not(HasSubstr("D4_volts"))) << "pin 4 is no analog input";
}

TEST_F(Vcd, AbbreviatesNoTwoSignalsAlike) {
  const std::string vcd = text_of(record);
  std::vector<std::string> ids;
  for (const char* signal : {"D0", "D1", "D13", "A5", "D5_duty", "A0_volts", "A5_volts", "tx", "rx"})
    ids.push_back(id_of(vcd, signal));
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

TEST_F(Vcd, WritesAPinThatGoesUpAndDown) {
  record.add(output(1000, "D8", true));
  record.add(output(2500, "D8", false));
  const std::string vcd = text_of(record), id = id_of(vcd, "D8");
  EXPECT_THAT(vcd, HasSubstr("#1000\n1" + id + "\n"));
  EXPECT_THAT(vcd, HasSubstr("#2500\n0" + id + "\n"));
}

TEST(VcdOfSeveral, HasAScopeForEachRobotAndKeepsTheirPinsApart) {
  RecordedRun run;
  run.robot_info.board.name = "uno";
  for (const char* name : {"A", "B"}) {
    run.robots.push_back({name, "", "", "", {}});
    run.robots.back().info.board.name = "uno";
  }
  VcdRecorder record{waves()};
  record.begin(run);
  wire::PinChange up{1000, "D8", "output", true, false, 1.0, 0};
  up.agent = 1;
  record.add(up);
  up.agent = 2;
  up.t_ns = 2000;
  record.add(up);  // agents are numbered from 0, so there is no agent 2
  const std::string vcd = text_of(record);
  const std::size_t second = vcd.find("$scope module B $end\n");
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(vcd.find("$scope module A $end\n"), second);
  const std::string other = id_of(vcd, "D8"), own = id_of(vcd.substr(second), "D8");
  EXPECT_NE(own, other);
  EXPECT_THAT(vcd, HasSubstr("#1000\n1" + own + "\n"));
  EXPECT_THAT(vcd, Not(HasSubstr("#2000\n")));
}

TEST_F(Vcd, WritesPwmAsItsDuty) {
  record.add(wire::PinChange{7, "D5", "output", false, true, 0.25, 0});
  const std::string vcd = text_of(record);
  EXPECT_THAT(vcd, HasSubstr("r0.25 " + id_of(vcd, "D5_duty") + "\n"));
  EXPECT_THAT(vcd, HasSubstr("x" + id_of(vcd, "D5") + "\n")) << "neither high nor low";
}

TEST_F(Vcd, WritesWhatTheAdcSampled) {
  record.add(wire::VoltsSeen{5000, "A2", 3.75});
  const std::string vcd = text_of(record);
  EXPECT_THAT(vcd, HasSubstr("#5000\nr3.75 " + id_of(vcd, "A2_volts") + "\n"));
}

TEST_F(Vcd, TellsTwoEqualBytesApart) {
  record.add(wire::SerialByte{10, 'a', true});
  record.add(wire::SerialByte{20, 'a', true});
  const std::string vcd = text_of(record), flip = id_of(vcd, "tx_flip");
  EXPECT_THAT(vcd, HasSubstr("b1100001 " + id_of(vcd, "tx") + "\n"));
  EXPECT_THAT(vcd, HasSubstr("#10\n"));
  EXPECT_THAT(vcd, HasSubstr("#20\n0" + flip + "\n"));
}

TEST_F(Vcd, SortsWhatComesOutOfOrder) {
  record.add(output(300, "D8", true));
  record.add(wire::LevelSeen{200, "D2", true});
  const std::string vcd = text_of(record);
  EXPECT_LT(vcd.find("#200\n"), vcd.find("#300\n"));
}

// The run is so long that the recorder writes parts of the file before the end of the run.
TEST_F(Vcd, IsInTheOrderOfTimeAndHoldsEachChangeOnceHoweverLongItIs) {
  constexpr int kChanges = 30'000;
  constexpr std::int64_t kEvery_ns = 1'000'000;
  for (int i = 1; i <= kChanges; ++i) {
    record.add(wire::VoltsSeen{i * kEvery_ns, "A0", i % 7 + 0.1});
    record.add(output(i * kEvery_ns - 900'000'000 + 5, "D8", i % 2 == 0));  // reported 0.9 s late
    record.add(output(i * kEvery_ns - 900'000'000 + 5, "D8", i % 2 == 0));
  }
  const std::string vcd = text_of(record), volts = " " + id_of(vcd, "A0_volts") + "\n",
                    level = id_of(vcd, "D8") + "\n";
  long long last = 0;
  int changes = 0, edges = 0;
  for (std::size_t at = vcd.find("\n#0\n") + 3; (at = vcd.find("\n#", at)) != vcd.npos; ++at) {
    const std::size_t end = vcd.find('\n', at + 2), next = vcd.find('#', end);
    const long long t = std::stoll(vcd.substr(at + 2, end - at - 2));
    ASSERT_GT(t, last);
    last = t;
    const std::string here = vcd.substr(end + 1, next == vcd.npos ? next : next - end - 1);
    changes += here.ends_with(volts);
    edges += here == "1" + level || here == "0" + level;
    if (t % kEvery_ns == 5) {
      ASSERT_EQ(here, (((t + 900'000'000) / kEvery_ns) % 2 == 0 ? "1" : "0") + level) << t;
    }
  }
  EXPECT_EQ(changes, kChanges);
  EXPECT_EQ(edges, kChanges - 899) << "changes before the run have no time of their own";
}

TEST_F(Vcd, AChangeThatIsToldTooLateToBePutInOrderStandsWhereItWasTold) {
  record.add(output(1'000'000, "D8", true));
  for (std::int64_t i = 0; i < 20'000; ++i)
    record.add(wire::VoltsSeen{2'000'000 * i, "A0", static_cast<double>(i) + 0.5});
  record.add(output(2'000'000, "D8", false));
  const std::string vcd = text_of(record);
  const std::size_t late = vcd.find("\n0" + id_of(vcd, "D8") + "\n");
  ASSERT_NE(late, vcd.npos);
  EXPECT_GT(std::stoll(vcd.substr(vcd.rfind('#', late) + 1)), 1'000'000'000);
}

TEST_F(Vcd, EndsWithTheLastWholeHundredthOfASecond) {
  result::RunResult result, other;
  result.time_s = 0.042;
  other.time_s = 0.067;
  result.others = {other};
  const test::TemporaryFolder folder;
  VcdRecorder on_disk(folder.path() / "x.vcd");
  RecordedRun run;
  run.robot_info.board.name = "uno";
  on_disk.begin(run);
  on_disk.finish(result);
  EXPECT_TRUE(read_file(folder.path() / "x.vcd").ends_with("$end\n#60000000\n"));
}

}  // namespace record_vcd_test
}  // namespace robosim::record
