// Tests `--record x.vcd` with an independent reader: GTKWave's converters.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace record_vcd_test {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

struct Change {
  long long t_ns;
  std::string value;
};
using Waves = std::map<std::string, std::vector<Change>>;  // by signal

bool has_gtkwave() { return std::system("command -v vcd2fst fst2vcd >/dev/null 2>&1") == 0; }

// Reads a file with GTKWave's converters: from VCD to FST, and back to VCD.
Waves read_back(const Folder& folder, const std::string& vcd) {
  const std::string at = "cd '" + folder.path().string() + "' && ";
  const std::string convert = at + "vcd2fst " + vcd + " x.fst >/dev/null && fst2vcd x.fst >back.vcd";
  EXPECT_EQ(std::system(convert.c_str()), 0);
  std::istringstream in(read_file(folder / "back.vcd"));
  Waves waves;
  std::map<std::string, std::string> names;
  long long now = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first, type, bits, id, name;
    words >> first;
    if (first == "$var") {
      words >> type >> bits >> id >> name;
      names[id] = name;
      waves[name];
    } else if (first[0] == '#') {
      now = std::atoll(first.c_str() + 1);
    } else if (first[0] == 'r' || first[0] == 'b') {
      words >> id;
      waves[names[id]].push_back({now, first.substr(1)});
    } else if (!first.empty() && std::string("01xz").find(first[0]) != std::string::npos) {
      waves[names[first.substr(1)]].push_back({now, first.substr(0, 1)});
    }
  }
  return waves;
}

class RecordVcd : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const bool lacking = !has_gtkwave();
    if (lacking && is_required("gtkwave")) FAIL() << "GTKWave's converters are missing: apt install gtkwave";
    if (lacking) GTEST_SKIP() << "GTKWave's converters are missing: apt install gtkwave";
    ROBOSIM_NEEDS_TARGET(GetParam());
  }
  Ended record(const std::string& sketch, const char* duration) {
    folder_.write("hello/hello.ino", sketch);
    return robosim_command({"run", "./hello", "--robot", "uno5", "--map", "oval", "--goal", "none", "--for",
                            duration, "--target", GetParam(), "--record", "x.vcd"},
                           folder_.path());
  }
  const Folder folder_;
};

TEST_P(RecordVcd, AReaderThatIsNotOursFindsPinsVoltsDutyAndBytes) {
  const Ended run = record(
      "void setup() { Serial.begin(9600); pinMode(13, OUTPUT); pinMode(5, OUTPUT); Serial.print(\"aab\"); }\n"
      "void loop() {\n"
      "  analogRead(A0); analogWrite(5, 64); digitalWrite(13, HIGH); delay(10);\n"
      "  analogWrite(5, 128); digitalWrite(13, LOW); delay(10);\n"
      "}\n",
      "100ms");
  ASSERT_EQ(run.status, 0) << run.err;
  const Waves waves = read_back(folder_, "x.vcd");
  for (const char* signal : {"D0", "D13", "A5", "D3_duty", "D11_duty", "D8_tone_hz", "A5_volts", "rx"})
    EXPECT_EQ(waves.count(signal), 1u) << signal << " is declared, although it never changes";

  std::vector<std::string> sent;
  for (const Change& change : waves.at("tx")) sent.push_back(change.value);
  EXPECT_THAT(sent, ElementsAre("00000000", "01100001", "01100010"));
  EXPECT_THAT(waves.at("tx_flip"), SizeIs(1 + 3)) << "three bytes, two of them equal";

  std::vector<double> duties, volts;
  for (const Change& change : waves.at("D5_duty")) duties.push_back(std::stod(change.value));
  EXPECT_THAT(duties, Contains(64.0 / 255).Times(0)) << "the pin is high in 65 of Timer0's 256 steps";
  EXPECT_THAT(duties, Contains(65.0 / 256));
  EXPECT_THAT(duties, Contains(129.0 / 256));
  for (const Change& change : waves.at("A0_volts")) volts.push_back(std::stod(change.value));
  EXPECT_GT(volts.size(), 4u) << "noise changes each sample";

  const std::vector<Change>& led = waves.at("D13");
  ASSERT_GT(led.size(), 8u);
  const std::size_t last = led.size() - 1;
  EXPECT_NEAR(static_cast<double>(led[last].t_ns - led[last - 1].t_ns), 10e6, 1.1e6) << "delay(10)";
}

TEST_P(RecordVcd, ACrashLeavesWhatWasRecorded) {
  const bool chip = GetParam() == std::string("avr");
  const Ended run =
      record(std::string("void setup() { pinMode(13, OUTPUT); digitalWrite(13, HIGH); delay(20); ") +
                 (chip ? "*(volatile int*)0x4000 = 1;" : "*(volatile int*)0 = 1;") + " }\nvoid loop() {}\n",
             "100ms");
  ASSERT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("crashed"));
  const Waves waves = read_back(folder_, "x.vcd");
  EXPECT_EQ(waves.at("D13").back().value, "1");
}

INSTANTIATE_TEST_SUITE_P(Targets, RecordVcd, ::testing::Values("host", "avr"),
                         [](const auto& target) { return std::string(target.param); });

}  // namespace record_vcd_test
}  // namespace robosim::test
