#include "sim/run/stop_conditions.h"

#include <fmt/format.h>

#include <algorithm>

#include "hal/board/board_spec.h"
#include "sim/base/did_you_mean.h"

namespace robosim::run {
namespace {

constexpr double kReadingOn = 0.5;
constexpr std::size_t kLongestLine = 1000;  // bytes

bool matches(const PinDrive& drive, bool level) {
  return drive.mode == PinMode::output && (drive.duty > 0.0) == level;
}

std::size_t station_index(const judge::Progress& progress, const std::string& name) {
  const std::vector<judge::Waypoint>& stations = progress.stations();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (stations[i].name == name || std::to_string(i + 1) == name) return i;
    names.push_back(stations[i].name);
  }
  throw InputError(names.empty() ? fmt::format("unknown station {}: the map has no stations", name)
                                 : fmt::format("unknown station: {}", expected_one_of(name, names)));
}

const robot::Reading* find_reading(const std::vector<robot::Reading>& readings, const std::string& part) {
  for (const robot::Reading& reading : readings)
    if (reading.part == part) return &reading;
  return nullptr;
}

}  // namespace

StopConditions::Watch StopConditions::watch_for(const Stop& stop) const {
  Watch watch;
  watch.stop = stop;
  watch.searched = stop.from;
  switch (stop.kind) {
    case Stop::Kind::visited:
    case Stop::Kind::at:
      watch.station = station_index(scene_.progress, stop.text);
      break;
    case Stop::Kind::pin:
      watch.pin = find_pin(scene_.board.spec(), stop.text.c_str());
      if (watch.pin == kNoPin)
        throw InputError(fmt::format("the board {} has no pin {}", scene_.board.spec().name, stop.text));
      break;
    case Stop::Kind::reading: {
      const std::vector<robot::Reading> readings = scene_.robot.readings();
      if (find_reading(readings, stop.text)) break;
      std::vector<std::string> names;
      for (const robot::Reading& reading : readings) names.emplace_back(reading.part);
      throw InputError(names.empty()
                           ? fmt::format("unknown part to read: {}: the robot has none", stop.text)
                           : fmt::format("unknown part to read: {}", expected_one_of(stop.text, names)));
    }
    case Stop::Kind::line:
      watch.line = LinePattern(stop.text);
      break;
    case Stop::Kind::event: {
      const std::vector<std::string>& kinds = result::event_kinds();
      if (std::find(kinds.begin(), kinds.end(), stop.text) == kinds.end())
        throw InputError(fmt::format("unknown event: {}", expected_one_of(stop.text, kinds)));
      break;
    }
    default:
      break;
  }
  if (stop.text.empty() && (stop.kind == Stop::Kind::serial || stop.kind == Stop::Kind::note))
    throw InputError("the text to wait for: expected a string that is not empty");
  return watch;
}

void StopConditions::check(const Leg& leg) const {
  for (const Stop& stop : leg.stops)
    if (stop.agent == scene_.agent) watch_for(stop);
}

void StopConditions::begin(const Leg& leg, SimTime t) {
  state_.watches.clear();
  for (std::size_t i = 0; i < leg.stops.size(); ++i) {
    const Stop& stop = leg.stops[i];
    if (stop.agent != scene_.agent) continue;
    state_.watches.push_back(watch_for(stop));
    Watch& watch = state_.watches.back();
    watch.number = static_cast<int>(i);
    watch.rest_since = t;
    if (watch.pin != kNoPin) watch.met = matches(scene_.board.drive(watch.pin), stop.level);
  }
  state_.until = leg.until;
  state_.met = -1;
}

void StopConditions::pin_changed(Pin pin, const PinDrive& drive) {
  for (Watch& watch : state_.watches)
    if (watch.pin == pin && matches(drive, watch.stop.level)) watch.met = true;
}

void StopConditions::happened(const result::RunEvent& event) {
  for (Watch& watch : state_.watches) {
    if (watch.stop.kind == Stop::Kind::event && watch.stop.text == result::kind_of(event)) watch.met = true;
    if (watch.stop.kind == Stop::Kind::note &&
        result::text_of(event).find(watch.stop.text) != std::string::npos)
      watch.met = true;
  }
}

bool StopConditions::says(Watch& watch) const {
  if (scene_.serial.find(watch.stop.text, watch.searched) != std::string::npos) return true;
  // Includes the end of the present output in the next search, because the text may begin there.
  const std::size_t kept = std::min(scene_.serial.size(), watch.stop.text.size() - 1);
  watch.searched = std::max(watch.searched, scene_.serial.size() - kept);
  return false;
}

bool StopConditions::says_line(Watch& watch) const {
  for (;;) {
    const std::size_t end = scene_.serial.find('\n', watch.searched);
    if (end == std::string::npos) return false;
    std::string line = scene_.serial.substr(watch.searched, std::min(end - watch.searched, kLongestLine));
    if (!line.empty() && line.back() == '\r') line.pop_back();
    watch.searched = end + 1;
    if (watch.line->is_in(line)) return true;
  }
}

bool StopConditions::is_met(Watch& watch, SimTime t) const {
  const Stop& stop = watch.stop;
  switch (stop.kind) {
    case Stop::Kind::serial:
      return says(watch);
    case Stop::Kind::line:
      return says_line(watch);
    case Stop::Kind::visited:
      return scene_.progress.stations()[watch.station].visited;
    case Stop::Kind::at:
      return scene_.body.covers(scene_.progress.stations()[watch.station].centre);
    case Stop::Kind::reading: {
      const std::vector<robot::Reading> readings = scene_.robot.readings();
      const robot::Reading* reading = find_reading(readings, stop.text);
      return reading && (reading->value >= kReadingOn) == stop.level;
    }
    case Stop::Kind::motors:
      return scene_.robot.driven() == stop.level;
    case Stop::Kind::rest:
      if (scene_.body.wheel_rate(world::left) != 0.0 || scene_.body.wheel_rate(world::right) != 0.0)
        watch.rest_since = t;
      return t - watch.rest_since >= stop.rest_ns;
    case Stop::Kind::note:
    case Stop::Kind::event:
    case Stop::Kind::pin:
      return watch.met;
  }
  return false;
}

bool StopConditions::look(SimTime t) {
  for (Watch& watch : state_.watches)
    if (state_.met < 0 && is_met(watch, t)) state_.met = watch.number;
  return state_.met >= 0 || t >= state_.until;
}

}  // namespace robosim::run
