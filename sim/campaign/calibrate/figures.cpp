#include "sim/campaign/calibrate/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robosim::calibrate {
namespace {

constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;
constexpr double kKgCm = 0.0980665;
constexpr double kGCm2 = 1e-7;

double before_of(const Parameter& number) { return number.in(Profile::typical_2).value; }

/// Returns the number of decimals that show two digits of the spread.
int decimals(double spread) {
  if (!(spread > 0.0)) return 3;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(spread * (1.0 + 1e-9)))), 0, 6);
}

struct Written {
  std::string value, spread;
};

Written written(const Figure& figure, const Found& found) {
  // For a value out of bounds, uses the part of the value's range (± spread) that is within the bounds.
  const double low = std::max(found.value - spread_of(found), figure.least) / figure.scale;
  const double high = std::min(found.value + spread_of(found), figure.most) / figure.scale;
  const bool beyond = found.value < figure.least || found.value > figure.most;
  const double value = beyond ? 0.5 * (low + high) : found.value / figure.scale;
  double spread = std::min(value - low, high - value);
  const int digits = decimals(spread);
  const double unit = std::pow(10.0, -digits);
  // Reduces the spread if the rounded range (value ± spread) could exceed the bounds.
  const double rounded = std::floor(value / unit + 0.5) * unit;
  const double room = std::min(rounded - figure.least / figure.scale, figure.most / figure.scale - rounded);
  if (spread > room - unit) spread = std::max(std::floor(room / unit + 1e-9) * unit, 0.0);
  return {fmt::format("{:.{}f}", rounded, digits), fmt::format("{:.{}f}", spread, digits)};
}

std::string with_unit(const std::string& number, const Figure& figure) {
  return *figure.unit ? fmt::format("\"{} {}\"", number, figure.unit) : number;
}

}  // namespace

double spread_of(const Found& found) { return 2.0 * found.sd; }

double unsureness(const Figure& figure, const Found& found) {
  return spread_of(found) / (figure.against > 0.0 ? figure.against : std::fabs(found.value));
}

double least_sure(const Figure& figure) {
  double most = 0.0;
  for (const Found& found : figure.found) most = std::max(most, unsureness(figure, found));
  return most;
}

bool is_possible(const Figure& figure) {
  return std::all_of(figure.found.begin(), figure.found.end(), [&](const Found& found) {
    return found.value + spread_of(found) >= figure.least && found.value - spread_of(found) <= figure.most;
  });
}

std::string shown(const Figure& figure, const Found& found) {
  const Written text = written(figure, found);
  const std::string unit = *figure.unit ? std::string(" ") + figure.unit : "";
  return fmt::format("{}{} ± {}{}", text.value, unit, text.spread, unit);
}

std::string toml_value(const Figure& figure) {
  const auto one = [&](const Found& found) {
    const Written text = written(figure, found);
    return fmt::format("{{ value = {}, spread = {} }}", with_unit(text.value, figure),
                       with_unit(text.spread, figure));
  };
  if (figure.of.empty()) return one(figure.found.front());
  std::string list = "[\n";
  for (std::size_t i = 0; i < figure.found.size(); ++i)
    list += fmt::format("  {},  # {}\n", one(figure.found[i]), figure.of[i]);
  return list + "]";
}

std::vector<Figure> figures_of(const SweepFit& fit, const robot::Description& robot) {
  std::vector<Figure> figures;
  for (const PartFit& part : fit.parts) {
    const robot::ReflectanceSpec& spec = *part.part;
    const bool rc = spec.read == robot::ReflectanceSpec::Read::rc;
    const Spread height = spec.height.in(Profile::typical_2);
    const double light = robot::light_from(height.value, Profile::typical_2);
    const double light_sd =
        std::fabs(robot::light_from(height.value + height.spread, Profile::typical_2) -
                  robot::light_from(std::max(height.value - height.spread, 0.0005), Profile::typical_2)) /
        (2.0 * std::numbers::sqrt3);
    const double most = rc ? 0.1 : robot.board->supply_volts;
    Figure white{spec.name,
                 true,
                 rc ? "white_time" : "white_volts",
                 {},
                 {},
                 rc ? "us" : "V",
                 rc ? 1e-6 : 1.0,
                 before_of(spec.elements.front().white),
                 rc ? 5e-6 : 0.0,
                 most,
                 ""};
    Figure black{spec.name,
                 true,
                 rc ? "black_time" : "black_volts",
                 {},
                 {},
                 rc ? "us" : "V",
                 rc ? 1e-6 : 1.0,
                 before_of(spec.elements.front().black),
                 rc ? 5e-6 : 0.0,
                 most,
                 ""};
    // Elements that are not in the log keep the file's values.
    for (const auto& element : spec.elements) {
      const auto seen = std::find_if(part.elements.begin(), part.elements.end(),
                                     [&](const ElementFit& e) { return e.name == element.name; });
      const auto own = [](const Parameter& number) {
        const Spread now = number.in(Profile::typical_2);
        return Found{now.value, 0.5 * now.spread};
      };
      Found w = own(element.white), b = own(element.black);
      if (seen != part.elements.end()) {
        b = seen->black;
        w = {(seen->white.value - (1.0 - light) * b.value) / light,
             std::hypot(seen->white.sd, light_sd * (seen->white.value - b.value)) / light};
        if (rc) {  // converts rates to times
          w = {1.0 / w.value, w.sd / (w.value * w.value)};
          b = {1.0 / b.value, b.sd / (b.value * b.value)};
        }
      }
      white.found.push_back(w);
      black.found.push_back(b);
      if (spec.type == "reflectance-array") {
        white.of.push_back(element.name);
        black.of.push_back(element.name);
      }
    }
    if (!rc)
      white.against = black.against =
          std::max(std::fabs(black.found.front().value - white.found.front().value), 1e-3);
    figures.push_back(std::move(white));
    figures.push_back(std::move(black));
    if (part.footprint.value > 0.0)
      figures.push_back({spec.name,
                         true,
                         "footprint",
                         {part.footprint},
                         {},
                         "mm",
                         1e-3,
                         before_of(spec.footprint),
                         0.0005,
                         0.03,
                         ""});
    figures.push_back(
        {spec.name, true, "noise", {part.noise}, {}, "", 1.0, before_of(spec.noise), 0.0, 0.5, ""});
  }
  if (fit.track.value > 0.0)
    figures.push_back({"chassis",
                       false,
                       "track",
                       {fit.track},
                       {},
                       "mm",
                       1e-3,
                       before_of(robot.chassis.track),
                       0.02,
                       0.5,
                       "if wheel is correct"});
  return figures;
}

std::vector<Figure> figures_of(const DriveFit& fit, const robot::Description& robot) {
  std::vector<Figure> figures;
  const robot::Motors& m = robot.motors;
  const Found &left = fit.no_load[0], &right = fit.no_load[1];
  // A file has one value for both motors, so the value's spread covers both motors.
  const double half = 0.5 * std::fabs(left.value - right.value);
  const Found no_load{0.5 * (left.value + right.value), std::max(left.sd, right.sd) + 0.5 * half};
  figures.push_back(
      {"motors",
       false,
       "no_load",
       {no_load},
       {},
       "rpm",
       kRpm,
       before_of(m.no_load),
       5.0 * kRpm,
       6000.0 * kRpm,
       half > 0.0 ? fmt::format("left {:.0f} rpm, right {:.0f} rpm", left.value / kRpm, right.value / kRpm)
                  : ""});
  if (fit.torque_told)
    figures.push_back({"motors",
                       false,
                       "stall_torque",
                       {fit.stall_torque},
                       {},
                       "kg cm",
                       kKgCm,
                       before_of(m.stall_torque),
                       0.0001,
                       10.0,
                       "if mass, rotor_inertia and stall_current are correct"});
  if (fit.friction_told)
    figures.push_back({"motors",
                       false,
                       "no_load_current",
                       {fit.no_load_current},
                       {},
                       "mA",
                       1e-3,
                       before_of(m.no_load_current),
                       0.0,
                       0.8 * before_of(m.stall_current),
                       "if stall_current is correct"});
  if (fit.inertia.value > 0.0)
    figures.push_back({"chassis",
                       false,
                       "inertia",
                       {fit.inertia},
                       {},
                       "g cm2",
                       kGCm2,
                       before_of(robot.chassis.inertia),
                       1e-6,
                       0.5,
                       "if mass and rotor_inertia are correct"});
  return figures;
}

Figure supply_figure(Found supply, const robot::Description& robot) {
  return {"motors", false, "supply",     {supply}, {}, "V", 1.0, before_of(robot.motors.supply),
          1.0,      30.0,  "as measured"};
}

}  // namespace robosim::calibrate
