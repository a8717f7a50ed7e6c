#include "sim/wire/protocol.h"

#include <nlohmann/json.hpp>

namespace robosim::wire {
namespace {

using Json = nlohmann::json;

std::string quoted(std::string_view text) {
  constexpr std::size_t kMost = 120;
  std::string result;
  for (const char c : text.substr(0, kMost)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return "“" + result + (text.size() > kMost ? "…”" : "”");
}

/// A key of an object, converted; what() of a missing or mistyped one names the key.
template <typename T>
T get(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw RunnerError(std::string("the key ") + key + " is missing");
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    throw RunnerError(std::string("the key ") + key + " has a value of the wrong kind");
  }
}

template <typename T>
T get(const Json& object, const char* key, T fallback) {
  return object.contains(key) ? get<T>(object, key) : fallback;
}

/// A name or number as people read it: "8", "A0".
std::string as_text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::vector<std::string> as_texts(const Json& array) {
  std::vector<std::string> texts;
  for (const Json& value : array) texts.push_back(as_text(value));
  return texts;
}

Hello hello(const Json& json) {
  return {get<std::string>(json, "hello"), get<int>(json, "protocol"), get<std::string>(json, "version"),
          get<std::string>(json, "target")};
}

RobotInfo robot(const Json& json) {
  RobotInfo info;
  info.name = get<std::string>(json, "name");
  info.file = get<std::string>(json, "file");
  info.sha256 = get<std::string>(json, "sha256");
  const auto board = get<Json>(json, "board");
  info.board = {get<std::string>(board, "name"), get<std::string>(board, "fqbn"),
                get<std::string>(board, "macro")};
  if (json.contains("budget")) {
    const auto budget = get<Json>(json, "budget");
    info.budget = {get<std::int64_t>(budget, "flash_bytes"), get<std::int64_t>(budget, "ram_bytes")};
  }
  info.outline_mm = get<std::vector<std::array<double, 2>>>(json, "outline");
  for (const Json& sensor : get<Json>(json, "sensors")) {
    info.sensors.push_back(
        {get<std::string>(sensor, "name"), get<double>(sensor, "x"), get<double>(sensor, "y")});
  }
  for (const Json& part : get<Json>(json, "parts")) {
    RobotInfo::Part made{get<std::string>(part, "name"), get<std::string>(part, "type"), {}};
    const Json pins = get<Json>(part, "pins");
    for (const auto& [use, pin] : pins.items()) made.pins.emplace_back(use, as_text(pin));
    info.parts.push_back(std::move(made));
  }
  return info;
}

Started started(const Json& json) {
  Started event;
  const auto start = get<Json>(json, "start");
  if (!start.is_array() || start.size() != 3)
    throw RunnerError("the key start has a value of the wrong kind");
  event.x = start[0].get<int>();
  event.y = start[1].get<int>();
  const auto facing = start[2].get<std::string>();
  event.facing = facing.empty() ? 'E' : facing[0];
  event.goal = get<std::string>(json, "goal");
  for (const Json& station : get<Json>(json, "stations")) {
    event.stations.push_back({get<int>(station, "id"), get<std::string>(station, "name"),
                              get<int>(station, "x"), get<int>(station, "y")});
  }
  event.readings = get<std::vector<std::string>>(json, "readings");
  event.width = get<int>(json, "width", 0);
  event.height = get<int>(json, "height", 0);
  event.cell_mm = get<double>(json, "cell", 0.0);
  return event;
}

Sample sample(const Json& json) {
  return {get<std::int64_t>(json, "t_us"),
          get<double>(json, "x"),
          get<double>(json, "y"),
          get<double>(json, "yaw"),
          get<double>(json, "speed_mm_s"),
          get<double>(json, "cross_track"),
          get<double>(json, "left"),
          get<double>(json, "right"),
          get<std::vector<double>>(json, "readings"),
          get<std::string>(json, "at", "")};
}

Source source(const Json& json) {
  const auto found = json.find("source");
  if (found == json.end()) return {};
  return {get<std::string>(*found, "function"), get<std::string>(*found, "file"), get<int>(*found, "line")};
}

Event event(const Json& json) {
  const auto kind = get<std::string>(json, "event");
  if (kind == "sample") return sample(json);
  if (kind == "serial") return SerialText{get<std::int64_t>(json, "t_ns"), get<std::string>(json, "text")};
  if (kind == "note") return Note{get<std::int64_t>(json, "t_ns"), get<std::string>(json, "text")};
  if (kind == "started") return started(json);
  if (kind == "pin") {
    return PinChange{get<std::int64_t>(json, "t_ns"),
                     get<std::string>(json, "pin"),
                     get<std::string>(json, "mode"),
                     get<bool>(json, "level"),
                     get<bool>(json, "pwm"),
                     get<double>(json, "duty"),
                     get<std::uint32_t>(json, "tone_hz", 0),
                     source(json)};
  }
  if (kind == "debugger_awaited") return DebuggerAwaited{get<int>(json, "port")};
  if (kind == "level")
    return LevelSeen{get<std::int64_t>(json, "t_ns"), get<std::string>(json, "pin"), get<bool>(json, "level"),
                     source(json)};
  if (kind == "volts")
    return VoltsSeen{get<std::int64_t>(json, "t_ns"), get<std::string>(json, "pin"),
                     get<double>(json, "volts"), source(json)};
  if (kind == "byte")
    return SerialByte{get<std::int64_t>(json, "t_ns"), get<std::uint8_t>(json, "value"),
                      get<bool>(json, "sent"), source(json)};
  throw RunnerError("there is no event " + kind);
}

Metrics metrics(const Json& json) {
  Metrics m;
  m.distance_m = get<double>(json, "distance_m");
  m.laps_s = get<std::vector<double>>(json, "laps_s");
  m.cross_track_rms_mm = get<double>(json, "cross_track_rms_mm");
  m.cross_track_max_mm = get<double>(json, "cross_track_max_mm");
  m.off_line_s = get<double>(json, "off_line_s");
  m.collisions = get<int>(json, "collisions");
  m.energy_j = get<double>(json, "energy_j");
  m.stations = as_texts(get<Json>(json, "stations"));
  m.junctions = get<int>(json, "junctions");
  return m;
}

Resources resources(const Json& json) {
  Resources r;
  r.flash_bytes = get<std::int64_t>(json, "flash_bytes");
  r.ram_bytes = get<std::int64_t>(json, "ram_bytes");
  r.stack_bytes_max = get<std::int64_t>(json, "stack_bytes_max");
  r.loops = get<std::int64_t>(json, "loops", 0);
  r.loop_us_max = get<double>(json, "loop_us_max", 0.0);
  r.loop_us_mean = get<double>(json, "loop_us_mean", 0.0);
  r.interrupt_share = get<double>(json, "interrupt_share");
  r.cpu_load = get<double>(json, "cpu_load");
  return r;
}

RunResult result(const Json& json) {
  RunResult r;
  r.verdict = get<std::string>(json, "verdict");
  r.why = get<std::string>(json, "why");
  r.next = get<std::string>(json, "next", "");
  r.status = get<int>(json, "status");
  r.time_s = get<double>(json, "time_s");
  r.goal = get<std::string>(json, "goal");
  r.for_s = get<double>(json, "for_s");
  r.seed = get<std::uint64_t>(json, "seed");
  r.profile = get<std::string>(json, "profile");
  r.metrics = metrics(get<Json>(json, "metrics"));
  if (const auto crash = json.find("crash"); crash != json.end() && crash->is_object()) {
    r.crash = Crash{get<std::string>(*crash, "reason"),
                    get<std::string>(*crash, "function", ""),
                    get<std::string>(*crash, "file", ""),
                    get<int>(*crash, "line", 0),
                    {},
                    {}};
    for (const Json& call : get<Json>(*crash, "calls", Json::array())) {
      r.crash->calls.push_back(
          {get<std::string>(call, "function"), get<std::string>(call, "file"), get<int>(call, "line")});
    }
    r.crash->registers = get<std::string>(*crash, "registers", "");
    r.crash->check = get<std::string>(*crash, "check", "");
  }
  if (json.contains("resources")) r.resources = resources(get<Json>(json, "resources"));
  for (const Json& entry : get<Json>(json, "events")) {
    r.events.push_back({get<double>(entry, "t_s"), get<std::string>(entry, "text")});
  }
  r.serial = get<std::string>(json, "serial");
  const Json end = get<Json>(json, "end", Json::object());
  r.end_x_mm = get<double>(end, "x", 0.0);
  r.end_y_mm = get<double>(end, "y", 0.0);
  r.end_yaw_rad = get<double>(end, "yaw", 0.0);
  r.eeprom_writes = get<std::uint64_t>(json, "eeprom_writes", 0);
  r.trace_hash = get<std::string>(json, "trace_hash");
  r.map_sha256 = get<std::string>(json, "map_sha256");
  r.robot_sha256 = get<std::string>(json, "robot_sha256");
  r.image_sha256 = get<std::string>(json, "image_sha256");
  return r;
}

Paused paused(const Json& json) {
  Paused p;
  p.t_ns = get<std::int64_t>(json, "t_ns");
  p.sample = sample(get<Json>(json, "sample"));
  p.stop = get<int>(json, "stop", -1);
  const auto worst = get<Json>(json, "worst");
  p.worst_cross_track_mm = get<double>(worst, "cross_track");
  p.worst_t_ns = get<std::int64_t>(worst, "t_ns");
  p.worst_x_mm = get<double>(worst, "x");
  p.worst_y_mm = get<double>(worst, "y");
  p.powered = get<bool>(json, "powered");
  p.driven = get<bool>(json, "driven");
  p.serial_bytes = get<std::size_t>(json, "serial_bytes");
  p.metrics = metrics(get<Json>(json, "metrics"));
  if (json.contains("resources")) p.resources = resources(get<Json>(json, "resources"));
  return p;
}

Eeprom eeprom(const std::string& digits) {
  Eeprom memory;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    memory.bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return memory;
}

Json stop_json(const Stop& stop) {
  switch (stop.kind) {
    case Stop::Kind::serial:
      return {{"serial", stop.text}, {"from", stop.from}};
    case Stop::Kind::line:
      return {{"line", stop.text}, {"from", stop.from}};
    case Stop::Kind::note:
      return {{"note", stop.text}};
    case Stop::Kind::visited:
      return {{"visited", stop.text}};
    case Stop::Kind::at:
      return {{"at", stop.text}};
    case Stop::Kind::reading:
      return {{"reading", stop.text}, {"level", stop.level}};
    case Stop::Kind::pin:
      return {{"pin", stop.text}, {"level", stop.level}};
    case Stop::Kind::motors:
      return {{"motors", stop.level}};
    case Stop::Kind::rest:
      return {{"rest_ns", stop.rest_ns}};
  }
  return {};
}

Line line_from(const Json& json) {
  if (!json.is_object()) throw RunnerError("it is no object");
  if (json.contains("hello")) return {-1, hello(json)};
  const auto id = get<long long>(json, "id");
  if (json.contains("event")) return {id, event(json)};
  if (json.contains("result")) return {id, result(get<Json>(json, "result"))};
  if (json.contains("robot")) return {id, robot(get<Json>(json, "robot"))};
  if (json.contains("paused")) return {id, paused(get<Json>(json, "paused"))};
  if (json.contains("accepted"))
    return {id, Accepted{get<std::string>(get<Json>(json, "accepted"), "lines")}};
  if (json.contains("eeprom")) return {id, eeprom(get<std::string>(json, "eeprom"))};
  if (json.contains("refused")) return {id, Refused{get<std::string>(json, "refused")}};
  const auto error = get<Json>(json, "error");
  return {id, ErrorAnswer{get<std::string>(error, "kind"), get<std::string>(error, "message")}};
}

/// File names and scenarios may hold any bytes; JSON may not.
std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

Line parse_line(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw RunnerError("the runner said something that is not JSON: " + quoted(text));
  try {
    return line_from(json);
  } catch (const std::exception& error) {
    throw RunnerError(std::string("the runner said something unexpected (") + error.what() +
                      "): " + quoted(text));
  }
}

std::string describe_robot_line(long long id, const std::string& robot) {
  return line({{"id", id}, {"do", "describe_robot"}, {"robot", robot}});
}

std::string run_line(long long id, const RunRequest& r) {
  Json json{{"id", id},         {"do", "run"},        {"image", r.image}, {"map", r.map},
            {"robot", r.robot}, {"for_ns", r.for_ns}, {"seed", r.seed},   {"profile", r.profile}};
  if (!r.start.empty()) json["start"] = r.start;
  if (!r.goal.empty()) json["goal"] = r.goal;
  if (!r.script.empty()) {
    json["script"] = r.script;
    json["script_file"] = r.script_file;
  }
  if (!r.counters.empty()) json["counters"] = r.counters;
  if (r.clock_ns > 0) json["clock_ns"] = r.clock_ns;
  if (r.gdb_port > 0) json["gdb_port"] = r.gdb_port;
  if (r.samples_every_ns > 0) json["samples_every_ns"] = r.samples_every_ns;
  if (r.interactive) json["interactive"] = true;
  if (r.source_ns) json["source"] = {r.source_ns->first, r.source_ns->second};
  Json stream = Json::array();
  if (r.pins) stream.push_back("pin");
  if (r.serial) stream.push_back("serial");
  if (r.notes) stream.push_back("note");
  if (r.io) stream.push_back("io");
  if (!stream.empty()) json["stream"] = stream;
  return line(json);
}

std::string act_line(long long id, const std::string& lines) {
  return line({{"id", id}, {"do", "script"}, {"lines", lines}});
}

std::string go_on_line(long long id, std::int64_t to_ns, const std::vector<Stop>& stops) {
  Json json{{"id", id}, {"do", "continue"}};
  if (to_ns >= 0) json["to_ns"] = to_ns;
  if (!stops.empty()) {
    Json until = Json::array();
    for (const Stop& stop : stops) until.push_back(stop_json(stop));
    json["until"] = std::move(until);
  }
  return line(json);
}

std::string eeprom_line(long long id) { return line({{"id", id}, {"do", "eeprom"}}); }

std::string end_line(long long id) { return line({{"id", id}, {"do", "end"}}); }

}  // namespace robosim::wire
