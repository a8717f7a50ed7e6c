#include "sim/cli/run/fleet_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/run_options.h"

namespace robosim::cli {
namespace {

std::string label(const char* option) { return *option ? option : "SKETCH"; }

}  // namespace

Named named(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == word.npos || equals == 0 || word.find_first_of("./") < equals) return {"", word};
  return {word.substr(0, equals), word.substr(equals + 1)};
}

FleetOptions::FleetOptions(Options& options, launch::RunSettings& run, bool compares)
    : run_(run),
      command_(compares ? "compare" : "run"),
      given_{Given{"", [](launch::Launch& l) -> std::string& { return l.sketch; }},
             Given{"--robot", [](launch::Launch& l) -> std::string& { return l.robot; }},
             Given{"--target", [](launch::Launch& l) -> std::string& { return l.target; }},
             Given{"--start", [](launch::Launch& l) -> std::string& { return l.request.start; }},
             Given{"--goal", [](launch::Launch& l) -> std::string& { return l.request.goal; }}} {
  options.positionals("[SKETCH]", given_[0].values,
                      "run this sketch: a folder, an .ino file or the name of a sample sketch (default: the "
                      "current folder); for several robots a fleet's .toml, or NAME=SKETCH for each "
                      "(docs/howto/fleets.md)",
                      PossibleValues::sketch());
  options.texts("--robot", given_[1].values, "ROBOT",
                "use this robot: a file, or the name of a stock robot; ROBOT@BOARD puts it on another board; "
                "NAME=... sets this, --target, --start, --goal or --script for one of several robots",
                PossibleValues::robot());
  if (!compares)
    options.texts("--target", given_[2].values, "TARGET", "execute on host, avr or stm32 (default: host)",
                  targets());
  options.texts("--start", given_[3].values, "X,Y,DIR", kStartHelp);
  options.texts("--goal", given_[4].values, "GOAL", kGoalHelp, goals());
  options.texts("--script", scripts_, "FILE", kScriptHelp, PossibleValues::file());
}

void FleetOptions::check_known(const char* option, const std::string& name) {
  launch::Fleet& fleet = run_.fleet;
  if (fleet.find(name)) return;
  if (fleet.members.empty())
    throw InputError(
        fmt::format("{} {}=...: unknown robot; this run has one robot, without a name", option, name));
  std::vector<std::string> names;
  for (const launch::Member& other : fleet.members) names.push_back(other.name);
  throw InputError(fmt::format("{}: unknown robot{}{}: {}", label(option), fleet.file.empty() ? "" : " in ",
                               fleet.file, expected_one_of(name, names)));
}

launch::Member& FleetOptions::member(const char* option, const std::string& name) {
  launch::Fleet& fleet = run_.fleet;
  if (launch::Member* known = fleet.find(name)) return *known;
  launch::check_member_name(name, {label(option)});
  if (!fleet.file.empty()) check_known(option, name);
  if (fleet.members.size() == result::kMostAgents)
    throw InputError(fmt::format("{}: too many robots with {}: expected at most {}", label(option), name,
                                 result::kMostAgents));
  launch::Member fresh;
  fresh.name = name;
  fleet.members.push_back(std::move(fresh));
  return fleet.members.back();
}

void FleetOptions::read_file() {
  std::vector<std::string>& words = given_[0].values;
  const auto file = std::find_if(words.begin(), words.end(), launch::is_fleet_file);
  if (file == words.end()) return;
  run_.fleet = launch::read_fleet(*file);
  words.erase(file);
}

void FleetOptions::take(const Given& given) {
  std::vector<std::string> had;
  for (const std::string& word : given.values) {
    const auto [name, value] = named(word);
    if (std::find(had.begin(), had.end(), name) != had.end()) {
      if (name.empty() && *given.option)
        throw InputError(fmt::format("{} is given more than once", given.option));
      if (name.empty())
        throw InputError(fmt::format("{0}: unexpected argument “{1}”; see robosim help {0}", command_, word));
      throw InputError(fmt::format("{} is given more than once for {}", label(given.option), name));
    }
    had.push_back(name);
    if (value.empty() && !name.empty())
      throw InputError(fmt::format("{}: {} lacks a value", label(given.option), word));
    launch::Launch& launch = name.empty() ? run_ : member(given.option, name).launch;
    given.of(launch) = value;
  }
}

void FleetOptions::take_scripts() {
  bool had = false;
  std::vector<std::string> names;
  for (const std::string& word : scripts_) {
    const auto [name, file] = named(word);
    if (name.empty()) {
      if (std::exchange(had, true)) throw InputError("--script is given more than once");
      run_.script = file;
      continue;
    }
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw InputError(fmt::format("--script is given more than once for {}", name));
    names.push_back(name);
    wire::RunRequest& request = member("--script", name).launch.request;
    request.script = launch::script_text(file);
    request.script_file = file;
  }
}

void FleetOptions::finish() {
  read_file();
  for (const Given& given : given_) take(given);
  take_scripts();
  if (run_.fleet.members.empty()) return;
  if (!run_.map.empty()) run_.fleet.map = run_.map;
  launch::fill_up(run_.fleet, run_);
  if (run_.request.clock_ns > 0)
    throw InputError("--clock applies to runs of one robot; a fleet file has the key “clock” for each robot");
}

}  // namespace robosim::cli
