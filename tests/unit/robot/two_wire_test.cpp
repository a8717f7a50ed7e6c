// Tests parts on the two-wire bus. The tests transfer bytes as firmware does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace two_wire_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TwoWireBench : public BenchRobot {
 public:
  explicit TwoWireBench(const std::string& part, const std::string& more = "",
                        Profile profile = Profile::ideal, std::uint64_t seed = 1)
      : BenchRobot("[[part]]\nname = \"it\"\ntype = \"" + part + "\"\n" + more, profile, seed) {}

  /// Sends the address and bytes. Returns whether the part acknowledged all of them.
  bool send(std::uint8_t address, const std::vector<int>& bytes) {
    bool heard = board.two_wire_address(static_cast<std::uint8_t>(address << 1), now);
    for (const int byte : bytes) heard &= board.two_wire_write(static_cast<std::uint8_t>(byte), now);
    board.two_wire_stop(now);
    return heard;
  }
  std::uint8_t get(std::uint8_t address, int reg) {
    return static_cast<std::uint8_t>(get16(address, reg) >> 8);
  }
  /// Returns the 16-bit value in register `reg` (high byte) and the next register (low byte).
  int get16(std::uint8_t address, int reg) {
    send(address, {reg});
    board.two_wire_address(static_cast<std::uint8_t>(address << 1 | 1), now);
    const int high = board.two_wire_read(now);
    const int low = board.two_wire_read(now);
    board.two_wire_stop(now);
    return high << 8 | low;
  }
  std::vector<std::string> told(int ms) {
    std::vector<PartText> all;
    for (int i = 0; i < ms; ++i) {
      tick();
      robot.poll_text(now, all);
    }
    std::vector<std::string> texts;
    for (const PartText& one : all) texts.push_back(one.text);
    return texts;
  }
};

std::string two_wire_error(const std::string& robot) {
  try {
    parse_description(robot, "bench.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(TwoWireParts, ShareTheBusAndAnswerToTheirAddressAlone) {
  TwoWireBench bench("lcd-i2c", "address = 0x3F\n[[part]]\nname = \"imu\"\ntype = \"mpu-6050\"\n");
  EXPECT_TRUE(bench.send(0x3F, {}));
  EXPECT_TRUE(bench.send(0x68, {0x75}));
  EXPECT_FALSE(bench.send(0x27, {}));
  EXPECT_EQ(bench.get(0x27, 0x75), 0xFF);
}

TEST(TwoWireParts, AreRefusedWhereTheBusIsNotToBeHad) {
  std::string file = kBareRobot + "[[part]]\nname = \"lcd\"\ntype = \"lcd-i2c\"\n";
  EXPECT_THAT(two_wire_error(file + "[[part]]\nname = \"go\"\ntype = \"button\"\npin = \"A4\"\n"),
              HasSubstr("pin A4 is already used by sda of lcd"));
  EXPECT_THAT(two_wire_error(file + "address = 3\n"), HasSubstr("address"));
  file.replace(file.find("nano"), 4, "bluepill");
  EXPECT_THAT(two_wire_error(file),
              AllOf(HasSubstr("lcd-i2c lcd requires a two-wire bus (I2C)"), HasSubstr("bluepill")));
}

TEST(LcdBehindAnExpander, ShowsWhatIsWrittenInHalvesWhereEFalls) {
  TwoWireBench bench("lcd-i2c");
  const auto half = [&](int lines, int rs) {
    bench.send(0x27, {lines | 0x0C | rs, lines | 0x08 | rs});
    bench.ticks(5);
  };
  const auto byte = [&](int value, int rs) {
    half(value & 0xF0, rs);
    half(value << 4 & 0xF0, rs);
  };
  for (const int lines : {0x30, 0x30, 0x30, 0x20}) half(lines, 0);
  for (const int command : {0x28, 0x0C, 0x01}) byte(command, 0);
  for (const char c : std::string("Lap 2")) byte(c, 1);
  byte(0xC0, 0);
  byte('9', 1);
  EXPECT_THAT(bench.told(60), ElementsAre("Lap 2|9"));
}

TEST(Ssd1306, TellsWhichPixelsAreLit) {
  TwoWireBench bench("ssd1306", "height = 32\n");
  bench.send(0x3C, {0x00, 0x20, 0x00, 0x21, 10, 12, 0x22, 1, 2, 0xAF});
  bench.send(0x3C, {0x40, 0x01, 0x01, 0x01, 0x80, 0x00, 0x00});  // three pixels at the top, one at the bottom
  EXPECT_THAT(bench.told(60), ElementsAre("4 lit in 10,8 to 12,23"));
  bench.send(0x3C, {0x80, 0xAE});
  EXPECT_THAT(bench.told(60), ElementsAre(" "));
  bench.send(0x3C, {0x80, 0xAF, 0x80, 0xA7});
  EXPECT_THAT(bench.told(60), ElementsAre("4092 lit in 0,0 to 127,31"));
}

// Draws "Lap 2" by columns, and "-1.5" below at twice the size. The lowest bit of a column is at the top.
TEST(Ssd1306, TellsTheTextThatItsPixelsSpell) {
  TwoWireBench bench("ssd1306");
  bench.send(0x3C, {0x00, 0x20, 0x00, 0x21, 0, 127, 0x22, 0, 7, 0xAF});
  std::vector<int> rows(3 * 128, 0);
  int x = 3;
  for (const std::array<int, 5>& letter : std::vector<std::array<int, 5>>{{0x7F, 0x40, 0x40, 0x40, 0x40},
                                                                          {0x20, 0x54, 0x54, 0x78, 0x40},
                                                                          {0xFC, 0x18, 0x24, 0x24, 0x18},
                                                                          {0x00, 0x00, 0x00, 0x00, 0x00},
                                                                          {0x72, 0x49, 0x49, 0x49, 0x46}}) {
    for (const int column : letter) rows[static_cast<std::size_t>(x++)] = column;
    ++x;
  }
  x = 0;
  for (const std::array<int, 5>& letter : std::vector<std::array<int, 5>>{{0x08, 0x08, 0x08, 0x08, 0x08},
                                                                          {0x00, 0x42, 0x7F, 0x40, 0x00},
                                                                          {0x00, 0x00, 0x60, 0x60, 0x00},
                                                                          {0x27, 0x45, 0x45, 0x45, 0x39}}) {
    for (const int column : letter)
      for (int twice = 0; twice < 2; ++twice, ++x) {
        unsigned large = 0;
        for (int bit = 0; bit < 8; ++bit)
          if (column >> bit & 1) large |= 3u << 2 * bit;
        rows[static_cast<std::size_t>(128 + x)] = static_cast<int>(large & 0xFF);
        rows[static_cast<std::size_t>(256 + x)] = static_cast<int>(large >> 8);
      }
    x += 2;
  }
  for (std::size_t i = 0; i < rows.size(); i += 16) {
    std::vector<int> bytes{0x40};
    bytes.insert(bytes.end(), rows.begin() + static_cast<std::ptrdiff_t>(i),
                 rows.begin() + static_cast<std::ptrdiff_t>(i) + 16);
    bench.send(0x3C, bytes);
  }
  EXPECT_THAT(bench.told(60), ElementsAre(HasSubstr(": Lap 2|-1.5")));
}

TEST(Mpu6050, SleepsUntilItIsWokenAndThenMeasuresTheRobotsMotion) {
  TwoWireBench bench("mpu-6050",
                     "[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { en = 5, in1 = 7, in2 = 8 }\n"
                     "[[part]]\nname = \"right\"\ntype = \"motor\"\npins = { en = 6, in1 = 9, in2 = 10 }\n");
  EXPECT_EQ(bench.get(0x68, 0x75), 0x68);
  bench.ticks(5);
  EXPECT_EQ(bench.get16(0x68, 0x3F), 0);
  bench.send(0x68, {0x6B, 0x00});
  bench.ticks(5);
  EXPECT_EQ(bench.get16(0x68, 0x3F), 16384);
  EXPECT_EQ(bench.get(0x68, 0x3A), 1);
  EXPECT_EQ(bench.get16(0x68, 0x41), static_cast<std::uint16_t>(static_cast<int>((25 - 36.53) * 340)));
  // The robot turns left on the spot.
  for (const Pin pin : {8, 9}) bench.board.output(pin, true, bench.now);
  for (const Pin pin : {7, 10}) bench.board.output(pin, false, bench.now);
  for (const Pin pin : {5, 6}) bench.board.output(pin, true, bench.now);
  bench.ticks(300);
  bench.send(0x68, {0x1B, 0x18});  // sets the range to +-2000 deg/s: 16.4 LSB/(deg/s)
  bench.ticks(5);
  const double degrees = bench.body().turn_rate() * 180.0 / std::numbers::pi;
  EXPECT_NEAR(static_cast<std::int16_t>(bench.get16(0x68, 0x47)) / 16.4, degrees,
              5.0);  // the turn is still accelerating
  EXPECT_GT(std::abs(degrees), 100.0);
  bench.send(0x68, {0x6B, 0x80});
  EXPECT_EQ(bench.get(0x68, 0x6B), 0x40);
}

TEST(Mpu6050, FeelsHowAHandTiltsTheRobot) {
  TwoWireBench bench("mpu-6050", "facing = \"90 deg\"\n");  // its x axis points to the robot's left
  bench.send(0x68, {0x6B, 0x00});
  const auto at = [&](int number) { return static_cast<std::int16_t>(bench.get16(0x68, number)); };
  const double degree = std::numbers::pi / 180.0;
  // The front is tilted down by 30 degrees, and tilts further at 100 degrees per second.
  bench.body().tilt({{0.5, 0.0}, 0.866025, {100 * degree, 0.0}});
  bench.ticks(5);
  EXPECT_NEAR(at(0x3B), 0, 1);
  EXPECT_NEAR(at(0x3D), 8192, 1) << "the sensor's y axis points back, which is up";
  EXPECT_NEAR(at(0x3F), 14189, 1);
  EXPECT_NEAR(at(0x43), 13100, 1) << "a turn about the left axis, by the right-hand rule";
  EXPECT_NEAR(at(0x45), 0, 1);
  bench.body().tilt({{0.0, 1.0}, 0.0, {0.0, 0.0}});  // the robot lies on its left side, at rest
  bench.ticks(5);
  EXPECT_NEAR(at(0x3B), -16384, 1);
  EXPECT_NEAR(at(0x3F), 0, 1);
  EXPECT_NEAR(at(0x43), 0, 1);
  bench.body().lift(false);
  bench.ticks(5);
  EXPECT_EQ(at(0x3B), 0);
  EXPECT_EQ(at(0x3F), 16384);
}

TEST(Mpu6050, IsAsWellMadeAsItsDataSheetSaysInTypical2) {
  const auto differs_by = [](Profile profile, std::uint64_t seed) {
    TwoWireBench bench("mpu-6050", "bias = \"0 deg/s\"\nnoise = \"0 deg/s\"\n", profile, seed);
    bench.send(0x68, {0x6B, 0x00});
    bench.body().tilt({{0.0, 0.0}, 1.0, {200 * std::numbers::pi / 180.0, 0.0}});
    bench.ticks(5);
    return std::pair{static_cast<std::int16_t>(bench.get16(0x68, 0x45)) / 26200.0 - 1.0,
                     static_cast<std::int16_t>(bench.get16(0x68, 0x3B)) / 16384.0};
  };
  double least = 0.0, most = 0.0, sideways = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto [scale, ahead] = differs_by(Profile::typical_2, seed);
    least = std::min(least, scale);
    most = std::max(most, scale);
    sideways = std::max(sideways, std::abs(ahead));
    EXPECT_NEAR(differs_by(Profile::typical, seed).first, 0.0, 1e-4);
  }
  EXPECT_GE(least, -0.0301);
  EXPECT_LT(least, -0.02);
  EXPECT_GT(most, 0.02);
  EXPECT_LE(most, 0.0301);
  EXPECT_GT(sideways, 0.035);
  EXPECT_LT(sideways, 0.05 + 5 * 0.0039);
}

TEST(Pca9685, TellsThePulsesOfItsChannels) {
  TwoWireBench bench("pca9685");
  bench.send(0x40, {0xFE, 121});  // 25 MHz / 4096 / (121 + 1) = 50 Hz
  bench.send(0x40, {0x00, 0x20});
  bench.send(0x40, {0xFE, 3});                       // ignored while the chip is awake
  bench.send(0x40, {0x06, 0x00, 0x00, 0x33, 0x01});  // channel 0: 307 of 4096
  bench.send(0x40, {0x0E, 0x00, 0x10, 0x00, 0x00});
  EXPECT_THAT(bench.told(60), ElementsAre("0:1498us 2:on"));
  bench.send(0x40, {0xFD, 0x10});
  EXPECT_THAT(bench.told(60), ElementsAre(" "));
}

TEST(Pca9685, DrivesWhatHangsOnItsChannels) {
  TwoWireBench bench("pca9685",
                     "[[part]]\nname = \"arm\"\ntype = \"servo\"\npin = \"it.15\"\n"
                     "[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { en = \"it.8\", in1 = \"it.10\", "
                     "in2 = \"it.9\" }\n");
  const auto reading = [&](const std::string& part) {
    for (const Reading& each : bench.robot.readings())
      if (each.part == part) return each.value;
    return -1.0;
  };
  bench.send(0x40, {0x00, 0x30});
  bench.send(0x40, {0xFE, 121});                     // 50 Hz
  bench.send(0x40, {0x42, 0x00, 0x00, 0xEC, 0x01});  // channel 15: 492 of 4096, 2.4 ms
  bench.ticks(400);
  EXPECT_NEAR(reading("arm"), 90.0, 1e-9) << "the chip sleeps";
  bench.send(0x40, {0x00, 0x20});
  bench.ticks(400);
  EXPECT_NEAR(reading("arm"), 180.0, 0.5);
  bench.send(0x40, {0x2E, 0x00, 0x10, 0x00, 0x00});  // channel 10: on
  bench.send(0x40, {0x26, 0x00, 0x00, 0x00, 0x04});  // channel 8: 1024 of 4096
  bench.tick();
  EXPECT_NEAR(bench.robot.left_command(), 0.25, 1e-9);
}

TEST(Pca9685, HasSixteenChannelsToBeNamed) {
  const std::string file = kBareRobot + "[[part]]\nname = \"it\"\ntype = \"pca9685\"\n";
  const auto led = [&](const std::string& pin) {
    return two_wire_error(file + "[[part]]\nname = \"led\"\ntype = \"led\"\npin = \"" + pin + "\"\n");
  };
  EXPECT_EQ(led("it.15"), "");
  EXPECT_THAT(led("it.16"), HasSubstr("expected an output of it, it.0 to it.15"));
  EXPECT_THAT(led("it.Q1"), HasSubstr("expected an output of it, it.0 to it.15"));
  EXPECT_THAT(led("other.1"),
              HasSubstr("unknown shift register or PWM driver in \"other.1\": expected it, got “other”"));
}

TEST(Tcs34725, TellsTheLineFromTheFloorAfterItsIntegration) {
  TwoWireBench on_line("tcs34725");
  TwoWireBench beside("tcs34725", "at = [\"0 mm\", \"40 mm\"]\n");
  int clear[2];
  for (int i = 0; i < 2; ++i) {
    TwoWireBench& bench = i == 0 ? on_line : beside;
    EXPECT_EQ(bench.get(0x29, 0x80 | 0x12), 0x44);
    bench.send(0x29, {0x80 | 0x01, 0xEB});  // sets the integration time to 50 ms
    bench.send(0x29, {0x80 | 0x0F, 0x01});
    bench.send(0x29, {0x80, 0x03});
    bench.ticks(49);
    EXPECT_EQ(bench.get(0x29, 0x93) & 1, 0);
    bench.ticks(3);
    EXPECT_EQ(bench.get(0x29, 0x93) & 1, 1);
    const int word = bench.get16(0x29, 0x94);
    clear[i] = (word & 0xFF) << 8 | word >> 8;
  }
  EXPECT_EQ(clear[0], 69);
  EXPECT_EQ(clear[1], 688);
}

TEST(Vl53l0x, MeasuresWhatIsBeforeItInItsTime) {
  TwoWireBench bench("vl53l0x");
  EXPECT_EQ(bench.get(0x29, 0xC0), 0xEE);
  bench.send(0x29, {0x00, 0x01});
  EXPECT_EQ(bench.get(0x29, 0x00) & 1, 0);
  bench.ticks(32);
  EXPECT_EQ(bench.get(0x29, 0x13) & 7, 0);
  bench.ticks(3);
  EXPECT_NE(bench.get(0x29, 0x13) & 7, 0);
  const double metres = bench.world.range_along(bench.number, bench.line(), {1.0, 0.0}, 5.0);
  EXPECT_NEAR(bench.get16(0x29, 0x1E), metres * 1000.0, 1.0);
  bench.send(0x29, {0x0B, 0x01});
  bench.ticks(50);
  EXPECT_EQ(bench.get(0x29, 0x13) & 7, 0);
  EXPECT_THAT(bench.told(1), IsEmpty());
}

}  // namespace two_wire_test
}  // namespace robosim::robot
