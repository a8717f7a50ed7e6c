// Lists the stock robots, the part types and the motor driver chips.
#include <algorithm>

#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/robot/description.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/bluetooth.h"
#include "sim/robot/parts/bumper.h"
#include "sim/robot/parts/button.h"
#include "sim/robot/parts/buzzer.h"
#include "sim/robot/parts/current_sensor.h"
#include "sim/robot/parts/encoder.h"
#include "sim/robot/parts/fan.h"
#include "sim/robot/parts/indicator.h"
#include "sim/robot/parts/ir_distance.h"
#include "sim/robot/parts/ir_receiver.h"
#include "sim/robot/parts/ir_switch.h"
#include "sim/robot/parts/keypad.h"
#include "sim/robot/parts/lcd.h"
#include "sim/robot/parts/lcd_i2c.h"
#include "sim/robot/parts/motor.h"
#include "sim/robot/parts/mpu6050.h"
#include "sim/robot/parts/pca9685.h"
#include "sim/robot/parts/radio.h"
#include "sim/robot/parts/reflectance.h"
#include "sim/robot/parts/serial_radio.h"
#include "sim/robot/parts/servo.h"
#include "sim/robot/parts/seven_segment.h"
#include "sim/robot/parts/shift_register.h"
#include "sim/robot/parts/ssd1306.h"
#include "sim/robot/parts/stepper.h"
#include "sim/robot/parts/tcs34725.h"
#include "sim/robot/parts/ultrasonic.h"
#include "sim/robot/parts/vl53l0x.h"
#include "sim/robot/parts/voltage.h"
#include "sim/robot/parts/wheel_servo.h"
#include "sim/robot/parts/ws2812.h"

namespace robosim::robot {
namespace fs = std::filesystem;

namespace {

fs::path stock_folder() {
  const fs::path data = data_folder();
  std::error_code error;
  const fs::path installed = data / "robots";
  return fs::is_directory(installed, error) ? installed : data / "sim/robot/stock";
}

}  // namespace

std::vector<std::string> stock_robots() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(stock_folder(), error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_robot(const std::string& name_or_path) {
  if (name_or_path.find_first_of("/.") != std::string::npos) return name_or_path;
  const std::vector<std::string> names = stock_robots();
  if (std::find(names.begin(), names.end(), name_or_path) == names.end())
    throw InputError(unknown_name("robot", name_or_path, names) + " (a name with / or . is a path)");
  return stock_folder() / (name_or_path + ".toml");
}

const std::vector<PartType>& part_types() {
  static const std::vector<PartType> types = {
      {"motor", read_motor},
      {"reflectance", read_reflectance},
      {"reflectance-array", read_reflectance_array},
      {"button", read_button},
      {"bumper", read_bumper},
      {"led", read_led},
      {"buzzer", read_buzzer},
      {"encoder", read_encoder},
      {"voltage", read_voltage},
      {"shift-register", read_shift_register},
      {"seven-segment", read_seven_segment},
      {"radio", read_radio},
      {"servo", read_servo},
      {"wheel-servo", read_wheel_servo},
      {"hc-sr04", read_ultrasonic},
      {"ir-distance", read_ir_distance},
      {"ir-switch", read_ir_switch},
      {"bluetooth", read_bluetooth},
      {"serial-radio", read_serial_radio},
      {"ir-receiver", read_ir_receiver},
      {"keypad", read_keypad},
      {"lcd", read_lcd},
      {"ws2812", read_ws2812},
      {"current-sensor", read_current_sensor},
      {"lcd-i2c", read_lcd_i2c},
      {"ssd1306", read_ssd1306},
      {"mpu-6050", read_mpu6050},
      {"vl53l0x", read_vl53l0x},
      {"tcs34725", read_tcs34725},
      {"pca9685", read_pca9685},
      {"stepper", read_stepper},
      {"fan", read_fan},
  };
  return types;
}

const std::vector<DriverChip>& driver_chips() {
  using enum Bridge;
  // Sources: the makers' datasheets. L298N (ST DS0218): 2.55 V at 1 A, 3.7 V at 2 A, typical; L293D (TI
  // SLRS008): 1.4 V high side + 1.2 V low side at 0.6 A; TB6612FNG (Toshiba): 0.5 ohm, both sides; DRV8833
  // (TI SLVSAR1): 0.36 ohm; DRV8835 (TI SLVSB18): 0.305 ohm. The first two chips are bipolar: the drop occurs
  // at any current.
  //
  // Freewheeling diodes: L298N modules have 1N5822 or FR107, estimated at 1 V; ST's data sheet requires at
  // most 1.2 V. L293D has an internal clamp of 1.3 V; TB6612FNG has 1 V, typical. The other chips use a
  // MOSFET's body diode, estimated at 0.8 V.
  static const std::vector<DriverChip> chips = {
      // A low EN opens the bridge. While EN is high, the two half bridges follow IN1 and IN2.
      {"l298n",
       1.4,
       1.15,
       1.0,
       false,
       {{{open, open}, {open, open}}, {{shorted, reverse}, {forward, shorted}}}},
      {"l293d",
       1.9,
       1.2,
       1.3,
       false,
       {{{open, open}, {open, open}}, {{shorted, reverse}, {forward, shorted}}}},
      // "EN" is the chip's PWM input. The bridge is open while IN1 and IN2 are low; else a low PWM brakes.
      {"tb6612",
       0.0,
       0.5,
       1.0,
       true,
       {{{open, shorted}, {shorted, shorted}}, {{open, reverse}, {forward, shorted}}}},
      // The chip has the IN/IN mode only. "EN" is its input nSLEEP.
      {"drv8833",
       0.0,
       0.36,
       0.8,
       true,
       {{{open, open}, {open, open}}, {{open, reverse}, {forward, shorted}}}},
      // In the mode PHASE/ENABLE, a low ENABLE brakes. In this mode, IN1 and IN2 always differ
      // (motor_driver.h). The mode IN/IN works as in the drv8833.
      {"drv8835",
       0.0,
       0.305,
       0.8,
       true,
       {{{open, shorted}, {shorted, shorted}}, {{open, reverse}, {forward, shorted}}}},
      // One transistor per motor, with a diode. The motor can neither reverse nor brake.
      {"transistor",
       0.1,
       0.1,
       0.8,
       true,
       {{{open, open}, {open, open}}, {{forward, forward}, {forward, forward}}}},
      // The driver inside a wheel servo. The servo's data sheet gives values for motor and driver together.
      // Other motors cannot use this driver.
      {"servo", 0.0, 0.0, 0.8, true, {{{open, open}, {open, open}}, {{open, open}, {open, open}}}},
  };
  return chips;
}

}  // namespace robosim::robot
