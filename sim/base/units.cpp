#include "sim/base/units.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/leading_number.h"

namespace robosim {
namespace {

struct Unit {
  Dimension dimension;
  const char* name;
  double si;
};

constexpr double kInch = 0.0254;
constexpr double kOunce = 0.028349523125;

// The units of each dimension, in the order used in messages.
constexpr Unit kUnits[] = {
    {Dimension::length, "mm", 1e-3},
    {Dimension::length, "cm", 1e-2},
    {Dimension::length, "m", 1.0},
    {Dimension::length, "in", kInch},
    {Dimension::time, "ns", 1e-9},
    {Dimension::time, "us", 1e-6},
    {Dimension::time, "ms", 1e-3},
    {Dimension::time, "s", 1.0},
    {Dimension::time, "min", 60.0},
    {Dimension::time, "h", 3600.0},
    {Dimension::time, "d", 86400.0},
    {Dimension::angle, "deg", std::numbers::pi / 180.0},
    {Dimension::angle, "rad", 1.0},
    {Dimension::voltage, "mV", 1e-3},
    {Dimension::voltage, "V", 1.0},
    {Dimension::current, "mA", 1e-3},
    {Dimension::current, "A", 1.0},
    {Dimension::mass, "g", 1e-3},
    {Dimension::mass, "kg", 1.0},
    {Dimension::inertia, "g mm2", 1e-9},
    {Dimension::inertia, "g cm2", 1e-7},
    {Dimension::inertia, "kg m2", 1.0},
    {Dimension::torque, "mN m", 1e-3},
    {Dimension::torque, "N m", 1.0},
    {Dimension::torque, "kg cm", kGravity * 1e-2},
    {Dimension::torque, "oz in", kOunce* kGravity* kInch},
    {Dimension::rotation_rate, "rpm", 2.0 * std::numbers::pi / 60.0},
    {Dimension::rotation_rate, "rad/s", 1.0},
    {Dimension::rotation_rate, "deg/s", std::numbers::pi / 180.0},
    {Dimension::speed, "mm/s", 1e-3},
    {Dimension::speed, "cm/s", 1e-2},
    {Dimension::speed, "m/s", 1.0},
    {Dimension::frequency, "Hz", 1.0},
    {Dimension::frequency, "kHz", 1e3},
    {Dimension::frequency, "MHz", 1e6},
    {Dimension::resistance, "ohm", 1.0},
    {Dimension::resistance, "kohm", 1e3},
    {Dimension::inductance, "uH", 1e-6},
    {Dimension::inductance, "mH", 1e-3},
    {Dimension::inductance, "H", 1.0},
    {Dimension::ratio, "%", 1e-2},
};

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

struct Split {
  double number;
  std::string_view unit;
};

std::optional<Split> split(std::string_view text) {
  text = trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto number = leading_number(text);
  if (!number) return std::nullopt;
  return Split{number->value, trim(text.substr(number->length))};
}

}  // namespace

std::string unit_names(Dimension dimension) {
  std::vector<std::string> names;
  if (dimension == Dimension::ratio) names.push_back("a bare number");
  for (const Unit& unit : kUnits)
    if (unit.dimension == dimension) names.push_back(unit.name);
  return one_of(names);
}

std::string si_unit(Dimension dimension) {
  for (const Unit& unit : kUnits)
    if (unit.dimension == dimension && unit.si == 1.0) return unit.name;
  return "";
}

std::optional<double> parse_quantity(std::string_view text, Dimension dimension) {
  const auto parts = split(text);
  if (!parts) return std::nullopt;
  if (dimension == Dimension::ratio && parts->unit.empty()) return parts->number;
  for (const Unit& unit : kUnits)
    if (unit.dimension == dimension && parts->unit == unit.name) return parts->number * unit.si;
  return std::nullopt;
}

std::optional<long long> parse_duration_ns(std::string_view text) {
  const auto seconds = parse_quantity(text, Dimension::time);
  if (!seconds || *seconds < 0.0 || *seconds > 9.0e9) return std::nullopt;
  return std::llround(*seconds * 1e9);
}

}  // namespace robosim
