#include "sim/build/hints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"

namespace robosim::build {
namespace {

constexpr const char* kBoards =
    "Robosim simulates the Blue Pill, and Arduino boards with an AVR chip (docs/reference/robots.md has the "
    "list)";

bool has(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

/// Returns the quoted names that precede the text `behind`, as in "'A8' was not declared". Each name appears
/// once.
std::vector<std::string> all_quoted(const std::string& text, const char* behind) {
  std::vector<std::string> names;
  const std::string what = std::string("'") + behind;
  for (std::size_t end = text.find(what); end != std::string::npos; end = text.find(what, end + 1)) {
    const std::size_t begin = end == 0 ? std::string::npos : text.rfind('\'', end - 1);
    if (begin == std::string::npos) continue;
    std::string name = text.substr(begin + 1, end - begin - 1);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

/// Returns the first quoted name before `behind`; empty if no name is found.
std::string quoted(const std::string& text, const char* behind) {
  const std::vector<std::string> names = all_quoted(text, behind);
  return names.empty() ? "" : names.front();
}

bool is_letter_and_digits(const std::string& name, char letter) {
  return name.size() > 1 && name.size() < 4 && name[0] == letter &&
         std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns "these boards have a pin A8: mega; …". `has` returns whether a board qualifies.
template <typename Has>
std::string boards_hint(const std::string& what, Has has) {
  std::vector<std::string> boards;
  for (int i = 0; const BoardSpec* const board = board_at(i); ++i)
    if (has(*board)) boards.emplace_back(board->name);
  if (boards.empty()) return fmt::format("no board has {}", what);
  return fmt::format("these boards have {}: {}; run the sketch on one of them with --robot NAME@BOARD", what,
                     fmt::join(boards, ", "));
}

/// Returns a hint for an undeclared pin or serial port. `missing` contains all undeclared names.
std::string pin_hint(const std::string& name, const std::vector<std::string>& missing) {
  if (is_letter_and_digits(name, 'D'))
    return fmt::format("{} is the name of a pin on an ESP8266; on Arduino boards it is {}", name,
                       name.substr(1));
  if (name.size() == 7 && name.rfind("Serial", 0) == 0 && name[6] >= '1' && name[6] <= '9')
    return boards_hint(name, [&](const BoardSpec& board) {
      return name[6] - '0' < board.chip->uart_count + (board.chip->usb.address ? 1 : 0);
    });
  if (!is_letter_and_digits(name, 'A')) return "";
  std::vector<std::string> pins;
  for (const std::string& other : missing)
    if (is_letter_and_digits(other, 'A')) pins.push_back(other);
  return boards_hint(fmt::format("{} {}", pins.size() > 1 ? "the pins" : "a pin", fmt::join(pins, ", ")),
                     [&](const BoardSpec& board) {
                       return std::all_of(pins.begin(), pins.end(), [&](const std::string& pin) {
                         return find_pin(board, pin.c_str()) != kNoPin;
                       });
                     });
}

struct Class {
  const char* name;
  const char* header;
};
constexpr std::array kClasses = {
    Class{"Servo", "Servo.h"},
    Class{"SoftwareSerial", "SoftwareSerial.h"},
    Class{"LiquidCrystal", "LiquidCrystal.h"},
    Class{"LiquidCrystal_I2C", "LiquidCrystal_I2C.h"},
    Class{"Wire", "Wire.h"},
    Class{"SPI", "SPI.h"},
    Class{"EEPROM", "EEPROM.h"},
    Class{"Encoder", "Encoder.h"},
    Class{"NewPing", "NewPing.h"},
    Class{"QTRSensors", "QTRSensors.h"},
    Class{"Stepper", "Stepper.h"},
    Class{"Keypad", "Keypad.h"},
    Class{"PID", "PID_v1.h"},
    Class{"IRrecv", "IRremote.h"},
    Class{"AF_DCMotor", "AFMotor.h"},
    Class{"Adafruit_NeoPixel", "Adafruit_NeoPixel.h"},
};

std::string class_hint(const std::string& name) {
  for (const Class& one : kClasses)
    if (name == one.name)
      return fmt::format("{} belongs to a library; put #include <{}> at the top", name, one.header);
  return "";
}

/// Returns a hint for an error of a sketch that was written for another version of a library. Each message in
/// the list names a class of the library, so a sketch with this error includes the library.
std::string version_hint(const std::string& first) {
  struct Versioned {
    const char* says;  ///< part of the compiler's message
    const char* library;
    const char* version;
  };
  static constexpr std::array list = {
      Versioned{"'QTRSensorsAnalog' does not name a type; did you mean 'QTRSensors'", "QTRSensors", "3.1.0"},
      Versioned{"'QTRSensorsRC' does not name a type; did you mean 'QTRSensors'", "QTRSensors", "3.1.0"},
      Versioned{"'QTRSensors::QTRSensors()' is protected", "QTRSensors", "4.0.0"},
  };
  for (const Versioned& one : list)
    if (has(first, one.says))
      return fmt::format(
          "the sketch is for another version of the library {0}; install it: arduino-cli lib install {0}@{1}",
          one.library, one.version);
  return "";
}

/// Returns the word of the sketch to which the first message's `^` points; empty if it points to no word.
std::string word_at_caret(const std::string& first) {
  std::istringstream lines(first);
  std::string before;
  for (std::string line; std::getline(lines, line); before = line) {
    const std::size_t caret = line.find('^');
    if (caret == std::string::npos || line.find_first_not_of(" |") != caret || caret >= before.size())
      continue;
    const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (std::isdigit(static_cast<unsigned char>(before[caret])) != 0) return "";
    const auto end =
        std::find_if_not(before.begin() + static_cast<std::ptrdiff_t>(caret), before.end(), is_letter);
    return {before.begin() + static_cast<std::ptrdiff_t>(caret), end};
  }
  return "";
}

bool is_of_esp32(const std::string& name) {
  return name.rfind("ledc", 0) == 0 || name.rfind("esp_", 0) == 0 || name == "WiFi" || name == "touchRead" ||
         name == "dacWrite";
}

}  // namespace

std::string hint_for(const std::string& messages) {
  // Considers only the first error, because later errors often follow from it.
  const std::size_t first_error = messages.find("error:");
  const std::string first = messages.substr(0, messages.find("error:", first_error + 1));
  const std::string undeclared = quoted(first, " was not declared");
  const std::string no_type = quoted(first, " does not name a type");
  if (is_of_esp32(undeclared))
    return fmt::format("{} belongs to the core of the ESP32; {}", undeclared, kBoards);
  if (no_type == "include" || no_type == "define") return fmt::format("write # before {0}: #{0}", no_type);
  if (no_type == "input" || no_type == "basic" || no_type == "pins")
    return fmt::format("this looks like a micro:bit's program; {}", kBoards);
  if (no_type == "from" || no_type == "import" || no_type == "def")
    return fmt::format("this looks like Python; a sketch is C++, and {}", kBoards);
  if (std::string hint = version_hint(first); !hint.empty()) return hint;
  for (const std::string& name : {undeclared, no_type}) {
    if (const std::string hint = pin_hint(name, all_quoted(messages, " was not declared")); !hint.empty())
      return hint;
    if (const std::string hint = class_hint(name); !hint.empty()) return hint;
  }
  if (has(first, "expected '{' before '::' token"))
    return "'namespace a::b { … }' is C++17, but sketches for the chip are C++11; write namespace a { "
           "namespace b { … } }";
  if (has(first, "before 'constexpr'")) return "'if constexpr' is C++17, but sketches for the chip are C++11";
  if (has(first, "expected ',' or ';' before") || has(first, "expected ';' before") ||
      has(first, "expected ';' after"))
    return "the previous line may lack a ; at its end";
  if (has(first, "expected '}' at end of input"))
    return "each { requires a }: one is missing at the end or earlier";
  if (has(first, "before numeric constant"))
    if (const std::string name = word_at_caret(first); !name.empty())
      return fmt::format(
          "{} is already a number in this chip's headers, such as a bit of a register; rename it", name);
  if (has(first, "redefinition of 'void setup()'") || has(first, "redefinition of 'void loop()'"))
    return "all .ino files of a folder form one sketch, with one setup() and one loop()";
  static const std::regex included(R"((?:^|\n)([^\n: ]+\.ino):[^\n]*error: redefinition of )");
  std::smatch match;
  if (std::regex_search(first, match, included) && has(first, "In file included from"))
    return fmt::format("all .ino files of a folder form one sketch: remove #include \"{}\"", match[1].str());
  if (has(first, "'const char*'") && has(first, "operator+"))
    return "to join texts in quotes, make a String of the first: String(\"a\") + 1";
  if (has(first, "lvalue required as left operand")) return "to compare, write ==";
  return "";
}

std::string library_of_header(const std::string& header) {
  struct Known {
    const char* header;
    const char* library;
  };
  static constexpr std::array list = {
      Known{"Servo.h", "Servo"},
      Known{"NewPing.h", "NewPing"},
      Known{"QTRSensors.h", "QTRSensors"},
      Known{"Encoder.h", "Encoder"},
      Known{"IRremote.h", "IRremote"},
      Known{"IRremote.hpp", "IRremote"},
      Known{"AFMotor.h", "Adafruit Motor Shield library"},
      Known{"Adafruit_MotorShield.h", "Adafruit Motor Shield V2 Library"},
      Known{"LiquidCrystal.h", "LiquidCrystal"},
      Known{"LiquidCrystal_I2C.h", "LiquidCrystal I2C"},
      Known{"PID_v1.h", "PID"},
      Known{"Keypad.h", "Keypad"},
      Known{"Stepper.h", "Stepper"},
      Known{"TimerOne.h", "TimerOne"},
      Known{"Adafruit_GFX.h", "Adafruit GFX Library"},
      Known{"Adafruit_SSD1306.h", "Adafruit SSD1306"},
      Known{"Adafruit_NeoPixel.h", "Adafruit NeoPixel"},
      Known{"Adafruit_PWMServoDriver.h", "Adafruit PWM Servo Driver Library"},
      Known{"Adafruit_TCS34725.h", "Adafruit TCS34725"},
      Known{"VL53L0X.h", "VL53L0X"},
      Known{"MPU6050_light.h", "MPU6050_light"},
      Known{"Arduino_FreeRTOS.h", "FreeRTOS"},
      Known{"L298N.h", "L298N"},
      Known{"L298NX2.h", "L298N"},
      Known{"SparkFun_TB6612.h", "SparkFun TB6612FNG Motor Driver Library"},
      Known{"SparkFun_APDS9960.h", "SparkFun APDS9960 RGB and Gesture Sensor"},
      Known{"Arduino_APDS9960.h", "Arduino_APDS9960"},
      Known{"DFRobotDFPlayerMini.h", "DFRobotDFPlayerMini"},
      Known{"Zumo32U4.h", "Zumo32U4"},
  };
  for (const Known& one : list)
    if (header == one.header) return one.library;
  return "";
}

std::string purpose_of_core_library(const std::string& header) {
  if (header == "Wire.h") return "a two-wire bus (I2C)";
  if (header == "SPI.h") return "an SPI";
  if (header == "SoftwareSerial.h") return "serial lines on any pins";
  return header == "HID.h" ? "USB" : "";
}

std::string foreign_header(const std::string& header) {
  struct Foreign {
    std::string_view header;  ///< a header's name, or the start of several names and a *
    const char* board;
  };
  static constexpr std::array list = {
      Foreign{"WiFi.h", "an ESP32"},
      Foreign{"WiFiClientSecure.h", "an ESP32"},
      Foreign{"BluetoothSerial.h", "an ESP32"},
      Foreign{"BLEDevice.h", "an ESP32"},
      Foreign{"ESP32*", "an ESP32"},
      Foreign{"WebServer.h", "an ESP32"},
      Foreign{"AsyncTCP.h", "an ESP32"},
      Foreign{"esp_*", "an ESP32"},
      Foreign{"soc/soc.h", "an ESP32"},
      Foreign{"soc/rtc_cntl_reg.h", "an ESP32"},
      Foreign{"driver/adc.h", "an ESP32"},
      Foreign{"driver/gpio.h", "an ESP32"},
      Foreign{"driver/ledc.h", "an ESP32"},
      Foreign{"driver/mcpwm.h", "an ESP32"},
      Foreign{"freertos/*", "an ESP32"},
      Foreign{"Preferences.h", "an ESP32"},
      Foreign{"ESPAsyncTCP.h", "an ESP8266"},
      Foreign{"ESP8266*", "an ESP8266"},
      Foreign{"ESPAsyncWebServer.h", "an ESP32 or ESP8266"},
      Foreign{"MicroBit.h", "a micro:bit"},
      Foreign{"pico/*", "an RP2040"},
      Foreign{"hardware/adc.h", "an RP2040"},
      Foreign{"hardware/gpio.h", "an RP2040"},
      Foreign{"hardware/pio.h", "an RP2040"},
      Foreign{"hardware/pwm.h", "an RP2040"},
      Foreign{"TeensyThreads.h", "a Teensy"},
      Foreign{"WiFiS3.h", "an Arduino Uno R4"},
      Foreign{"Arduino_LED_Matrix.h", "an Arduino Uno R4"},
      Foreign{"Arduino_LSM9DS1.h", "a Nano 33 BLE"},
  };
  for (const Foreign& one : list) {
    const bool many = one.header.ends_with('*');
    if (many ? header.starts_with(one.header.substr(0, one.header.size() - 1)) : header == one.header)
      return fmt::format("{} is for {}; {}", header, one.board, kBoards);
  }
  return "";
}

}  // namespace robosim::build
