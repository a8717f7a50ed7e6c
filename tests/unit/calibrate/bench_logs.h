// Generates calibration logs for tests, as the calibration sketch of a robot would print them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace robosim::calibrate::bench {

/// A robot with one sensor, S1, 70 mm ahead of the axle.
inline const char* kRobot = R"(board = "uno"
[chassis]
outline = { radius = "60 mm", at = ["0 mm", "0 mm"] }
mass = "280 g"
track = "98 mm"
wheel = "32 mm"
[motors]
voltage = "6 V"
no_load = "650 rpm"
no_load_current = "150 mA"
stall_torque = "0.74 kg cm"
stall_current = "1.5 A"
gear = 51.45
rotor_inertia = "0.1 g cm2"
supply = "7.4 V"
[driver]
chip = "tb6612"
[[part]]
name = "left"
type = "motor"
pins = { en = 5, in1 = 7, in2 = 8 }
[[part]]
name = "right"
type = "motor"
pins = { en = 6, in1 = 9, in2 = 10 }
[[part]]
name = "S1"
type = "reflectance"
pin = "A0"
at = ["70 mm", "0 mm"]
height = "2.5 mm"
[[part]]
name = "encoder_left"
type = "encoder"
pins = { a = 2 }
periods = 150
[[part]]
name = "encoder_right"
type = "encoder"
pins = { a = 3 }
periods = 150
)";

/// A sensor that passes a 19 mm tape every second, at 100 mm/s. Its footprint is 4 mm long.
struct Eye {
  int floor = 100, tape = 900;
  double first_s = 0.5, last_s = 6.0;  ///< outside of these times, the sensor reads only floor
  int most = 2000;
  int at(double t) const {
    const double into = std::fmod(t, 1.0) - 0.5;
    if (t < first_s || t > last_s) return floor;
    const double share = std::fmin(std::fmax((9.5 + 2.0 - std::fabs(100.0 * into)) / 4.0, 0.0), 1.0);
    const double ripple = 2.0 * std::sin(1000.0 * t);  // simulates noise
    return std::min(static_cast<int>(std::lround(floor + (tape - floor) * share + ripple)), most);
  }
};

inline std::string sweep(const Eye& eye = {}, const std::string& name = "S1", int rows = 1200) {
  std::string text = "t_us," + name + "\n";
  for (int i = 0; i < rows; ++i) text += fmt::format("{},{}\n", 5000 * i, eye.at(0.005 * i));
  return text;
}

/// Returns the log of a sensor's sweep over the tape, with encoder counts. Each encoder counts `per_second`
/// edges per second. The left wheel turns backward.
inline std::string counted_sweep(double per_second) {
  std::string text = "# counts_per_period = 2\nt_us,count_left,count_right,S1\n";
  for (int i = 0; i < 1200; ++i) {
    const auto count = static_cast<int>(per_second * 0.005 * i);
    text += fmt::format("{},{},{},{}\n", 5000 * i, -count, count, Eye{}.at(0.005 * i));
  }
  return text;
}

/// Returns the log of a drive at PWM value `told`. The encoders count `left` and `right` edges per second.
inline std::string drive(int told, double left, double right,
                         const char* head = "# counts_per_period = 2\n") {
  std::string text = std::string(head) + "t_us,left,right,count_left,count_right\n";
  for (int i = 0; i < 100; ++i)
    text +=
        fmt::format("{},{},{},{:.0f},{:.0f}\n", 5000 * i, told, told, left * 0.005 * i, right * 0.005 * i);
  return text;
}

}  // namespace robosim::calibrate::bench
