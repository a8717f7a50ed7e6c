#include "sim/runner/remote_controller.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <array>

#include "sim/base/error.h"
#include "sim/runner/keys.h"
#include "sim/runner/lines.h"

namespace robosim::runner {
namespace {

using nlohmann::json;
using Kind = run::Stop::Kind;

constexpr std::array<std::pair<const char*, Kind>, 9> kStops = {{{"serial", Kind::serial},
                                                                 {"line", Kind::line},
                                                                 {"note", Kind::note},
                                                                 {"visited", Kind::visited},
                                                                 {"at", Kind::at},
                                                                 {"reading", Kind::reading},
                                                                 {"pin", Kind::pin},
                                                                 {"motors", Kind::motors},
                                                                 {"rest_ns", Kind::rest}}};

run::Stop parse_stop(const json& object) {
  if (!object.is_object()) throw InputError("\"until\" must be an array of objects");
  Keys keys(object);
  run::Stop stop;
  int kinds = 0;
  for (const auto& [name, kind] : kStops) {
    if (!keys.find(name)) continue;
    ++kinds;
    stop.kind = kind;
    if (kind == Kind::rest)
      stop.time = keys.whole(name, 0);
    else if (kind == Kind::motors)
      stop.level = keys.truth(name, true);
    else
      stop.text = keys.text(name);
  }
  if (kinds != 1) {
    std::vector<std::string> names;
    for (const auto& entry : kStops) names.emplace_back(entry.first);
    throw InputError("each element of \"until\" needs one of the keys " + one_of(names));
  }
  if (stop.kind == Kind::serial || stop.kind == Kind::line)
    stop.from = static_cast<std::size_t>(keys.whole("from", 0));
  if (stop.kind == Kind::reading || stop.kind == Kind::pin) stop.level = keys.truth("level", true);
  keys.finish();
  return stop;
}

run::Leg parse_leg(const json& object) {
  Keys keys(object);
  keys.find("id");
  keys.find("do");
  run::Leg leg;
  leg.until = keys.whole("to_ns", kNever);
  if (const json* until = keys.find("until")) {
    if (!until->is_array()) Keys::wrong("until", "an array");
    for (const json& stop : *until) leg.stops.push_back(parse_stop(stop));
  }
  keys.finish();
  return leg;
}

}  // namespace

// A line that says no time happens now.
void RemoteController::add_lines(const json& request, run::Standstill& standstill) const {
  Keys keys(request);
  keys.find("id");
  keys.find("do");
  const std::string lines = keys.required_text("lines");
  keys.finish();
  std::string timed;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    const std::string line = lines.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      timed += fmt::format("at {}ms {}\n", standstill.state().t / kMillisecond, line);
    begin = end + 1;
  }
  standstill.add(scenario::parse_scenario(timed, script_file_));
  Json answer = with_id(id_);
  answer["accepted"] = {{"lines", timed}};
  write_line(answer);
}

run::Leg RemoteController::next(run::Standstill& standstill) {
  before_pause_(standstill.state().t);
  Json paused = with_id(id_);
  paused["paused"] = to_json(standstill.state(), standstill.sample());
  write_line(paused);
  for (;;) {
    const auto line = read_line(&interrupted_);
    if (!line && interrupted_.load(std::memory_order_relaxed)) return {.end = true};
    if (!line) ::_exit(0);  // the client has gone
    try {
      const json request = json::parse(*line, nullptr, false);
      const json what = request.is_object() ? request.value("do", json()) : json();
      if (what == "script") {
        add_lines(request, standstill);
      } else if (what == "continue") {
        run::Leg leg = parse_leg(request);
        standstill.check(leg);
        return leg;
      } else if (what == "eeprom") {
        Json answer = with_id(id_);
        answer["eeprom"] = fmt::format("{:02x}", fmt::join(standstill.eeprom(), ""));
        write_line(answer);
      } else if (what == "end") {
        return {.end = true};
      } else {
        throw InputError(fmt::format(
            "a run that stands still is asked \"script\", \"continue\", \"eeprom\" or \"end\", not {}",
            what.dump()));
      }
    } catch (const InputError& error) {
      Json refused = with_id(id_);
      refused["refused"] = error.what();
      write_line(refused);
    }
  }
}

}  // namespace robosim::runner
