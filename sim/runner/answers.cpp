#include "sim/runner/answers.h"

#include <numbers>

#include "hal/board/board_spec.h"
#include "sim/robot/netlist.h"

namespace robosim::runner {
namespace {

double millimetres(double metres) { return metres * 1e3; }
double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

}  // namespace

wire::Started to_wire(const run::Beginning& beginning) {
  wire::Started started;
  started.x = beginning.start.cell.x;
  started.y = beginning.start.cell.y;
  started.facing = map::letter(beginning.start.facing);
  started.goal = judge::to_string(beginning.goal);
  for (const map::Station& s : beginning.stations)
    started.stations.push_back({s.id, s.name, s.cell.x, s.cell.y});
  started.readings = beginning.readings;
  started.width = beginning.width;
  started.height = beginning.height;
  started.cell_mm = millimetres(beginning.cell_m);
  return started;
}

void to_wire(const run::Sample& s, wire::Sample& to) {
  to.t_us = s.t / kMicrosecond;
  to.x_mm = millimetres(s.pose.position.x);
  to.y_mm = millimetres(s.pose.position.y);
  to.yaw_rad = s.pose.yaw();
  to.speed_mm_s = millimetres(s.speed);
  to.cross_track_mm = millimetres(s.cross_track);
  to.left = s.left;
  to.right = s.right;
  to.readings = s.readings;
  if (!to.at_station.empty() || !s.at_station.empty()) to.at_station = s.at_station;
  to.wheels_mm_s = {millimetres(s.wheels[0]), millimetres(s.wheels[1])};
}

wire::Sample to_wire(const run::Sample& s) {
  wire::Sample sample;
  to_wire(s, sample);
  return sample;
}

std::array<double, 10> numbers_of(const run::Sample& s) {
  return {millimetres(s.pose.position.x), millimetres(s.pose.position.y), s.pose.heading.y, s.pose.heading.x,
          millimetres(s.speed),           millimetres(s.cross_track),     s.left,           s.right,
          millimetres(s.wheels[0]),       millimetres(s.wheels[1])};
}

wire::Paused to_wire(const run::State& state, const run::Sample& sample) {
  wire::Paused paused;
  paused.t_ns = state.t;
  paused.sample = to_wire(sample);
  paused.stop = state.stop;
  paused.worst = {millimetres(state.worst_cross_track), state.worst_t, millimetres(state.worst_at.x),
                  millimetres(state.worst_at.y)};
  paused.powered = state.powered;
  paused.driven = state.driven;
  paused.serial_bytes = state.serial_bytes;
  paused.metrics = state.metrics;
  paused.resources = state.resources;
  return paused;
}

std::string name_of(judge::NextStep::By by) {
  switch (by) {
    case judge::NextStep::By::none:
      break;
    case judge::NextStep::By::host:
      return "host";
    case judge::NextStep::By::watching:
      return "watching";
    case judge::NextStep::By::script:
      return "script";
  }
  return "";
}

result::RunResult to_wire(const judge::Outcome& outcome) {
  result::RunResult result;
  result.verdict = judge::to_string(outcome.verdict);
  result.why = outcome.why;
  result.next = outcome.next.text;
  result.next_by = name_of(outcome.next.by);
  result.status = static_cast<int>(judge::exit_status(outcome.verdict));
  result.time_s = seconds(outcome.time);
  result.metrics = outcome.metrics;
  result.crash = outcome.crash;
  result.divisions_by_zero = outcome.divisions_by_zero;
  result.lacks = outcome.lacks;
  result.watchdog_resets = outcome.watchdog_resets;
  result.detected = outcome.detected;
  result.resources = outcome.resources;
  result.usage = outcome.usage;
  result.because = outcome.because;
  for (const result::RunEvent& event : outcome.events)
    result.events.push_back({seconds(event.t_ns), result::text_of(event)});
  result.serial = outcome.serial;
  result.shown = outcome.shown;
  result.end = {millimetres(outcome.end.position.x), millimetres(outcome.end.position.y), outcome.end.yaw()};
  result.eeprom_writes = outcome.eeprom_writes;
  result.trace_hash = outcome.trace_hash;
  result.goal = judge::to_string(outcome.goal);
  return result;
}

wire::RobotInfo to_wire(const robot::Summary& robot) {
  wire::RobotInfo info;
  info.name = robot.name;
  info.file = robot.file;
  info.sha256 = robot.sha256;
  info.board = {robot.board->name, robot.board->fqbn, robot.board->macro};
  info.budget = {robot.budget.flash_bytes, robot.budget.ram_bytes};
  for (const Vec2 corner : robot.outline)
    info.outline_mm.push_back({millimetres(corner.x), millimetres(corner.y)});
  info.track_mm = millimetres(robot.track);
  info.wheel_mm = millimetres(robot.wheel);
  if (const auto& s = robot.steered)
    info.steering = {s->servo, millimetres(s->base), s->wheels, degrees(s->middle),
                     s->ratio, degrees(s->limit)};
  for (const robot::SensorPlace& s : robot.sensors)
    info.sensors.push_back({s.name, millimetres(s.at.x), millimetres(s.at.y), millimetres(s.footprint)});
  for (const robot::Gauge& gauge : robot.gauges) info.gauges.push_back({gauge.name, gauge.unit});
  for (const robot::PartSummary& part : robot.parts) {
    wire::RobotInfo::Part told{part.name, part.type, {}};
    for (const auto& [role, pin] : part.pins) {
      told.pins.emplace_back(
          role, robot::is_output(pin) ? robot::output_name(robot.registers, pin) : std::to_string(pin));
    }
    info.parts.push_back(std::move(told));
  }
  return info;
}

}  // namespace robosim::runner
