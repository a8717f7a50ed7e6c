#include "sim/campaign/calibrate/calibrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/robot_name.h"
#include "sim/campaign/calibrate/robot_text.h"
#include "sim/campaign/calibrate/stopwatch.h"

namespace robosim::calibrate {
namespace {

constexpr std::size_t kMostLog_bytes = std::size_t{64} << 20;
constexpr double kMeter = 0.01;  // relative error of a multimeter

bool is_path(const std::string& robot) { return robot.find_first_of("/.") != robot.npos; }

std::string what_is_impossible(const Figure& figure) {
  const auto beyond = [&](const Found& found) {
    return std::max(found.value - figure.most, figure.least - found.value);
  };
  const auto farthest =
      std::max_element(figure.found.begin(), figure.found.end(),
                       [&](const Found& a, const Found& b) { return beyond(a) < beyond(b); });
  std::string text =
      fmt::format("{0}.{1}: the logs require {2:.3g} {3}, but a robot file accepts {4:.3g} to {5:.3g} {3}",
                  figure.table, figure.key, farthest->value / figure.scale, figure.unit,
                  figure.least / figure.scale, figure.most / figure.scale);
  if (figure.key.starts_with("white_"))
    text +=
        "; the sensor's light decreases less with height than in the model: set height = \"2.5 mm\" and "
        "calibrate again";
  return text;
}

std::vector<std::string> what_is_not_told(const Calibration& c, bool supply_measured) {
  std::vector<std::string> all = c.sweep.remarks;
  if (c.sweep.parts.empty()) {
    all.push_back("the sensors: no log has a sweep of a sensor with more than two values");
  } else {
    all.push_back(
        "height and ambient: all sweeps have one floor and one height, so that white_volts or white_time "
        "includes both");
    for (const PartFit& part : c.sweep.parts) {
      if (part.footprint.value == 0.0)
        all.push_back(fmt::format(
            "{}.footprint: neighbouring readings are {:.1f} mm apart, more than the footprint's width; turn "
            "more slowly",
            part.part->name, 1e3 * part.spacing));
      for (const auto& element : part.part->elements)
        if (std::none_of(part.elements.begin(), part.elements.end(),
                         [&](const ElementFit& e) { return e.name == element.name; }))
          all.push_back(element.name + ": no log has its column");
    }
    if (c.sweep.track.value == 0.0) all.push_back("track: requires encoders, and sweeps of more than a turn");
  }
  if (!c.drive) {
    all.push_back("the motors: no log has a drive, and --stopwatch is not given");
    return all;
  }
  all.push_back("stall_current, gear, rotor_inertia and mass: motion shows only their combined effect");
  if (!c.drive->torque_told) all.push_back("stall_torque: requires drives of at least three durations");
  if (!c.drive->friction_told)
    all.push_back("no_load_current: requires drives at two voltages, or the coasting after each drive");
  if (c.drive->inertia.value == 0.0) all.push_back("the body's inertia: requires turns on the spot");
  all.push_back(
      "wheel, and the difference between the two wheels: counts show only angles; roll the robot ten turns "
      "along a tape measure");
  all.push_back("grip and static_friction: no wheel slips or sticks in these drives");
  if (!supply_measured)
    all.push_back(
        "supply: measure the battery's voltage during the drives and pass it with --supply; until then "
        "no_load is as uncertain as the supply");
  return all;
}

}  // namespace

Calibration calibrate(const Task& task) {
  Calibration result;
  result.robot = robot::load_description(task.robot);
  result.tape_m = task.tape_m;
  std::vector<Log> logs;
  for (const std::string& file : task.logs) {
    const std::string text = read_file(file, kMostLog_bytes);
    logs.push_back(read_as(FileKind::log, text, file, [&] { return parse_log(text, file); }));
  }
  std::vector<Timed> timed;
  Found supply{task.supply_volts, kMeter * task.supply_volts};
  if (!task.stopwatch.empty()) {
    const Stopwatch watch = read_stopwatch(task.stopwatch);
    timed = watch.drives;
    if (supply.value == 0.0 && watch.supply_volts > 0.0)
      supply = {watch.supply_volts, kMeter * watch.supply_volts};
  }
  for (const Log& log : logs)
    if (!log.sweeps.empty() && task.tape_m == 0.0)
      throw InputError({log.file, log.sweeps.front().line},
                       "a sweep over a tape requires the tape's width, as in --tape \"19 mm\"");
  result.sweep = fit_sweeps(logs, result.robot, task.tape_m);
  robot::Description robot = result.robot;
  if (result.sweep.track.value > 0.0) robot.chassis.track = {result.sweep.track.value, 0.0};
  result.drive = fit_drives(logs, timed, robot, supply);

  std::vector<Figure> all = figures_of(result.sweep, result.robot);
  if (supply.value > 0.0) all.push_back(supply_figure(supply, result.robot));
  if (result.drive)
    for (Figure& figure : figures_of(*result.drive, result.robot)) all.push_back(std::move(figure));
  std::vector<std::string> impossible;
  for (Figure& figure : all) {
    if (!is_possible(figure)) {
      impossible.push_back(what_is_impossible(figure));
      continue;
    }
    (least_sure(figure) <= kMostSpread ? result.figures : result.unsure).push_back(std::move(figure));
  }
  result.not_told = what_is_not_told(result, supply.value > 0.0);
  result.not_told.insert(result.not_told.begin(), impossible.begin(), impossible.end());
  return result;
}

std::string calibrated_text(const Task& task, const Calibration& result, const std::string& file) {
  const std::string name = parse_robot_name(task.robot).robot;
  const bool stock = !is_path(name);
  const std::string own = stock ? fmt::format("# {}, calibrated\nbase = \"{}\"\n", name, name)
                                : read_file(robot::find_robot(name));
  std::string text = with_figures(own, stock ? file : name, result.figures);
  robot::parse_description(text, file);
  return text;
}

}  // namespace robosim::calibrate
