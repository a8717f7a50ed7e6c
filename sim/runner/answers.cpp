#include "sim/runner/answers.h"

#include "sim/robot/netlist.h"

namespace robosim::runner {
namespace {

double seconds(SimTime t) { return static_cast<double>(t) * 1e-9; }
double millimetres(double metres) { return metres * 1e3; }

Json point(Vec2 p) { return Json::array({millimetres(p.x), millimetres(p.y)}); }

Json metrics(const judge::Metrics& m) {
  return {{"distance_m", m.distance_m},
          {"laps_s", m.laps_s},
          {"cross_track_rms_mm", m.cross_track_rms_mm},
          {"cross_track_max_mm", m.cross_track_max_mm},
          {"off_line_s", m.off_line_s},
          {"collisions", m.collisions},
          {"energy_j", m.energy_j},
          {"stations", m.stations},
          {"junctions", m.junctions}};
}

Json resources(const exec::Resources& r) {
  Json json = {{"flash_bytes", r.flash_bytes},
               {"ram_bytes", r.ram_bytes},
               {"stack_bytes_max", r.stack_bytes_max},
               {"interrupt_share", r.interrupt_share},
               {"cpu_load", r.cpu_load}};
  if (r.loops > 0) {
    json["loops"] = r.loops;
    json["loop_us_max"] = r.loop_us_max;
    json["loop_us_mean"] = r.loop_us_mean;
  }
  return json;
}

}  // namespace

Json to_json(const run::Beginning& beginning) {
  Json stations = Json::array();
  for (const grid::Station& s : beginning.stations)
    stations.push_back({{"id", s.id}, {"name", s.name}, {"x", s.cell.x}, {"y", s.cell.y}});
  const grid::Start& start = beginning.start;
  return {{"start", Json::array({start.cell.x, start.cell.y, std::string(1, grid::letter(start.facing))})},
          {"goal", judge::to_string(beginning.goal)},
          {"stations", std::move(stations)},
          {"readings", beginning.readings},
          {"width", beginning.width},
          {"height", beginning.height},
          {"cell", millimetres(beginning.cell_m)}};
}

Json to_json(const run::Sample& s) {
  Json json = {{"t_us", s.t / kMicrosecond},
               {"x", millimetres(s.pose.position.x)},
               {"y", millimetres(s.pose.position.y)},
               {"yaw", s.pose.yaw()},
               {"speed_mm_s", millimetres(s.speed)},
               {"cross_track", millimetres(s.cross_track)},
               {"left", s.left},
               {"right", s.right},
               {"readings", s.readings}};
  if (!s.at_station.empty()) json["at"] = s.at_station;
  return json;
}

Json to_json(const run::State& state, const run::Sample& sample) {
  Json json = {{"t_ns", state.t}, {"sample", to_json(sample)}};
  if (state.stop >= 0) json["stop"] = state.stop;
  json["worst"] = {{"cross_track", millimetres(state.worst_cross_track)},
                   {"t_ns", state.worst_t},
                   {"x", millimetres(state.worst_at.x)},
                   {"y", millimetres(state.worst_at.y)}};
  json["powered"] = state.powered;
  json["driven"] = state.driven;
  json["serial_bytes"] = state.serial_bytes;
  json["metrics"] = metrics(state.metrics);
  if (state.resources) json["resources"] = resources(*state.resources);
  return json;
}

Json to_json(const judge::Outcome& outcome) {
  Json json = {{"verdict", judge::to_string(outcome.verdict)},
               {"why", outcome.why},
               {"next", outcome.next},
               {"status", static_cast<int>(judge::exit_status(outcome.verdict))},
               {"time_s", seconds(outcome.time)},
               {"metrics", metrics(outcome.metrics)}};
  if (outcome.crash) {
    const exec::SourceLine& where = outcome.crash->where;
    json["crash"] = {{"reason", outcome.crash->reason},
                     {"function", where.function},
                     {"file", where.file},
                     {"line", where.line}};
    if (!outcome.crash->check.empty()) json["crash"]["check"] = outcome.crash->check;
    if (!outcome.crash->registers.empty()) {
      Json calls = Json::array();
      for (const exec::SourceLine& call : outcome.crash->calls)
        calls.push_back({{"function", call.function}, {"file", call.file}, {"line", call.line}});
      json["crash"]["calls"] = std::move(calls);
      json["crash"]["registers"] = outcome.crash->registers;
    }
  }
  if (outcome.resources) json["resources"] = resources(*outcome.resources);
  Json events = Json::array();
  for (const wire::RunEvent& event : outcome.events)
    events.push_back({{"t_s", seconds(event.t_ns)}, {"text", wire::text_of(event)}});
  json["events"] = std::move(events);
  json["serial"] = outcome.serial;
  json["end"] = {{"x", millimetres(outcome.end.position.x)},
                 {"y", millimetres(outcome.end.position.y)},
                 {"yaw", outcome.end.yaw()}};
  json["eeprom_writes"] = outcome.eeprom_writes;
  json["trace_hash"] = outcome.trace_hash;
  return json;
}

Json to_json(const robot::Summary& robot) {
  Json outline = Json::array(), sensors = Json::array(), parts = Json::array();
  for (const Vec2 corner : robot.outline) outline.push_back(point(corner));
  for (const robot::SensorPlace& s : robot.sensors)
    sensors.push_back({{"name", s.name}, {"x", millimetres(s.at.x)}, {"y", millimetres(s.at.y)}});
  for (const auto& part : robot.parts) {
    Json pins = Json::object();
    for (const auto& [role, pin] : part.pins) {
      if (robot::is_output(pin))
        pins[role] = robot::output_name(robot.registers, pin);
      else
        pins[role] = pin;
    }
    parts.push_back({{"name", part.name}, {"type", part.type}, {"pins", std::move(pins)}});
  }
  return {
      {"name", robot.name},
      {"file", robot.file},
      {"sha256", robot.sha256},
      {"board", {{"name", robot.board->name}, {"fqbn", robot.board->fqbn}, {"macro", robot.board->macro}}},
      {"budget", {{"flash_bytes", robot.budget.flash_bytes}, {"ram_bytes", robot.budget.ram_bytes}}},
      {"outline", std::move(outline)},
      {"sensors", std::move(sensors)},
      {"parts", std::move(parts)}};
}

std::string to_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace robosim::runner
