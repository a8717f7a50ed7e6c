// Guesses motor shields and devices on the two-wire bus. Their libraries receive only the number of a motor
// or an address, which determines the wiring.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {
namespace {

/// The outputs of each of the four motors.
struct Outputs {
  std::array<const char*, 4> en, in1, in2;
};
// Adafruit's motor shield v1 and its clones: AFMotor.h. A 74HC595 drives the directions.
constexpr Outputs kFirst{{"11", "3", "6", "5"},
                         {"\"shield.Q2\"", "\"shield.Q1\"", "\"shield.Q5\"", "\"shield.Q0\""},
                         {"\"shield.Q3\"", "\"shield.Q4\"", "\"shield.Q7\"", "\"shield.Q6\""}};
// Version 2 of this shield: Adafruit_MotorShield.h. A PCA9685 drives everything.
constexpr Outputs kSecond{{"\"shield.8\"", "\"shield.13\"", "\"shield.2\"", "\"shield.7\""},
                          {"\"shield.10\"", "\"shield.11\"", "\"shield.4\"", "\"shield.5\""},
                          {"\"shield.9\"", "\"shield.12\"", "\"shield.3\"", "\"shield.6\""}};

/// A motor of a shield.
struct Numbered {
  int number;  ///< 0 to 3
  const Given* given;
};

/// Returns the motors of a type whose first argument is 1 to 4, each number once.
std::vector<Numbered> motors_of(const Evidence& evidence, const char* type) {
  std::vector<Numbered> motors;
  for (const Given& given : evidence.names().given) {
    if (given.type != type || given.arguments.empty() || given.arguments[0].size() != 1) continue;
    const int number = given.arguments[0][0] - '1';
    const bool known =
        std::any_of(motors.begin(), motors.end(), [&](const Numbered& m) { return m.number == number; });
    if (number >= 0 && number < 4 && !known) motors.push_back({number, &given});
  }
  return motors;
}

std::string where(const Given& given) {
  return fmt::format("{}({}), {}:{}", given.type, given.arguments[0], given.spot.file, given.spot.line);
}

void add_motors(const Ways& ways, RobotDraft& draft, const std::vector<Numbered>& motors,
                const Outputs& outputs) {
  std::vector<Numbered> left, right, unknown;
  for (const Numbered& motor : motors) {
    // The digit in motor1 only repeats the motor's number on the shield.
    std::vector<std::string> words = words_of(motor.given->name);
    std::erase_if(words, [](const std::string& word) { return std::isdigit(word[0]) != 0; });
    const Side side = side_of(words);
    (side == Side::left ? left : side == Side::right ? right : unknown).push_back(motor);
  }
  const bool named = !left.empty() && !right.empty();
  if (!named) {
    left = {motors.begin(), motors.begin() + static_cast<std::ptrdiff_t>((motors.size() + 1) / 2)};
    right = {motors.begin() + static_cast<std::ptrdiff_t>((motors.size() + 1) / 2), motors.end()};
    draft.open.other_sides = true;
    if (ways.other_sides) std::swap(left, right);
  }
  if (named)
    for (const Numbered& motor : unknown)
      draft.questions.push_back(fmt::format(
          "the name of motor {} of the shield ({}) does not name a side: which side does it drive?",
          motor.number + 1, where(*motor.given)));
  for (const bool is_left : {true, false}) {
    const std::vector<Numbered>& side = is_left ? left : right;
    if (side.empty()) continue;
    const auto i = static_cast<std::size_t>(side.front().number);
    PartDraft part{is_left ? "left" : "right",
                   "motor",
                   {{"pins", fmt::format("{{ en = {}, in1 = {}, in2 = {} }}", outputs.en[i], outputs.in1[i],
                                         outputs.in2[i])}},
                   where(*side.front().given),
                   {}};
    if (!named) part.doubts.push_back("the left motor is guessed from the numbers of the motors");
    if (side.size() > 1)
      part.doubts.push_back(
          fmt::format("motors {} and {} are assumed to drive this side: they are one part, with {} times the "
                      "torque and current",
                      side[0].number + 1, side[1].number + 1, side.size()));
    draft.parts.push_back(std::move(part));
  }
}

struct Device {
  const char* type;  ///< class of the library's object
  const char* part;
};
constexpr std::array kDevices = {
    Device{"LiquidCrystal_I2C", "lcd-i2c"},  Device{"Adafruit_SSD1306", "ssd1306"},
    Device{"MPU6050", "mpu-6050"},           Device{"Adafruit_MPU6050", "mpu-6050"},
    Device{"Adafruit_TCS34725", "tcs34725"}, Device{"VL53L0X", "vl53l0x"},
    Device{"Adafruit_VL53L0X", "vl53l0x"},   Device{"Adafruit_PWMServoDriver", "pca9685"},
};

bool is_address(const std::string& argument) {
  return argument.size() == 4 && (argument.rfind("0x", 0) == 0 || argument.rfind("0X", 0) == 0);
}

}  // namespace

void guess_shields(Evidence& evidence, const Ways& ways, RobotDraft& draft) {
  const auto take = [&](std::initializer_list<const char*> pins) {
    for (const char* pin : pins) evidence.take(find_pin(evidence.board(), pin));
  };
  if (const auto motors = motors_of(evidence, "AF_DCMotor"); !motors.empty()) {
    draft.parts.push_back({"shield",
                           "shift-register",
                           {{"pins", "{ data = 8, clock = 4, latch = 12, enable = 7 }"}},
                           "of a motor shield v1",
                           {}});
    take({"D8", "D4", "D12", "D7"});
    for (const Numbered& motor : motors)
      take({("D" + std::string(kFirst.en[static_cast<std::size_t>(motor.number)])).c_str()});
    add_motors(ways, draft, motors, kFirst);
    draft.driver = "l293d";
  } else if (const auto second = motors_of(evidence, "getMotor"); !second.empty()) {
    draft.parts.push_back({"shield", "pca9685", {{"address", "0x60"}}, "of a motor shield v2", {}});
    add_motors(ways, draft, second, kSecond);
    draft.driver = "tb6612";
  }
  for (const Given& given : evidence.names().given)
    for (const Device& device : kDevices) {
      if (given.type != device.type) continue;
      PartDraft part{part_name(draft, given.name.empty() ? device.part : given.name),
                     device.part,
                     {},
                     fmt::format("{}, {}:{}", given.type, given.spot.file, given.spot.line),
                     {}};
      for (const std::string& argument : given.arguments)
        if (is_address(argument) && part.keys.empty()) part.keys.emplace_back("address", argument);
      draft.parts.push_back(std::move(part));
    }
  const bool has_bus = std::any_of(draft.parts.begin(), draft.parts.end(), [](const PartDraft& part) {
    return part.type == "pca9685" || std::any_of(kDevices.begin(), kDevices.end(), [&](const Device& device) {
             return part.type == device.part;
           });
  });
  const TwiSpec& bus = evidence.board().chip->twi;
  if (has_bus && bus.address != 0) take({bus.data, bus.clock});
}

}  // namespace robosim::wiring
