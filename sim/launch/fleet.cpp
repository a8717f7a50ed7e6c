#include "sim/launch/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "sim/base/config.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/file_scope.h"
#include "sim/base/units.h"

namespace robosim::launch {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestName = 32;

/// Prefixes a relative path with the fleet file's folder.
std::string named_path(const fs::path& folder, const std::string& word, const Place& place) {
  const std::string path = path_from(folder, word);
  check_in_scope(path, place);
  return path;
}

/// Reads one [[agent]].
class MemberReader {
 public:
  MemberReader(const ConfigValue& table, fs::path folder)
      : reader_(table, "[[agent]]"), folder_(std::move(folder)) {}

  Member member() {
    Member member;
    member.place = reader_.table().place;
    const ConfigValue& name = reader_.require("name");
    member.name = as_string(name, "name");
    check_member_name(member.name, name.place);
    Launch& launch = member.launch;
    launch.sketch =
        path_at("sketch", build::is_sketch_path(word_at("sketch"), folder_.empty() ? "." : folder_));
    if (launch.sketch.empty()) reader_.require("sketch");
    launch.robot = path_at("robot");
    launch.target = word_at("target");
    launch.environment = word_at("env");
    launch.libraries = libraries();
    launch.sanitize = reader_.boolean("sanitize", false);
    launch.request.start = word_at("start");
    launch.request.goal = word_at("goal");
    launch.request.clock_ns = clock();
    if (const std::string script = path_at("script", true); !script.empty()) {
      launch.request.script_file = script;
      launch.request.script = script_text(script);
    }
    reader_.finish();
    if (!launch.target.empty())
      at(reader_.table().find("target")->place, [&] { check_target(launch.target); });
    return member;
  }

 private:
  /// Returns the word at a key, or "" if the key is missing. Throws InputError for an empty word.
  std::string word_at(const char* key) {
    const ConfigValue* value = reader_.find(key);
    if (!value) return "";
    const std::string& word = as_string(*value, key);
    if (word.empty())
      throw InputError(value->place,
                       fmt::format("{}: expected a word, got an empty string; omit the key", key));
    return word;
  }
  /// Returns the path at a key, prefixed with the fleet file's folder. A name that is not a path stays
  /// unchanged, unless `always` is true.
  std::string path_at(const char* key, bool always = false) {
    const std::string word = word_at(key);
    if (word.empty() || !(always || is_path(word))) return word;
    return from_folder(word, reader_.table().find(key)->place);
  }
  std::string from_folder(const std::string& word, const Place& place) const {
    return named_path(folder_, word, place);
  }
  std::vector<std::string> libraries() {
    std::vector<std::string> folders;
    const ConfigValue* value = reader_.find("libraries");
    if (!value) return folders;
    if (value->kind != ConfigValue::Kind::array)
      return {from_folder(as_string(*value, "libraries"), value->place)};
    for (const ConfigValue& item : value->items)
      folders.push_back(from_folder(as_string(item, "libraries"), item.place));
    return folders;
  }
  std::int64_t clock() {
    const std::string word = word_at("clock");
    if (word.empty()) return 0;
    const auto ns = parse_duration_ns(word);
    if (!ns || *ns <= 0)
      throw InputError(
          reader_.table().find("clock")->place,
          fmt::format("clock: expected a time above 0 with a unit, as in \"49.7d\", got \"{}\"", word));
    return *ns;
  }
  template <class Check>
  static void at(const Place& place, Check check) {
    try {
      check();
    } catch (const InputError& error) {
      throw InputError(place, error.message());
    }
  }

  TableReader reader_;
  fs::path folder_;
};

/// Throws the error again, with the robot's name. If the error has no place in a file, adds the robot's place
/// in the fleet file.
[[noreturn]] void blame(const Member& member, const InputError& error) {
  if (error.place().file.empty())
    throw InputError(member.place, fmt::format("robot {}: {}", member.name, error.message()));
  throw InputError(error.place(), fmt::format("{} (robot {})", error.message(), member.name));
}

}  // namespace

Member* Fleet::find(const std::string& name) {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const Member& member) { return member.name == name; });
  return found == members.end() ? nullptr : &*found;
}

bool is_fleet_file(const std::string& word) { return fs::path(word).extension() == ".toml"; }

void check_member_name(const std::string& name, const Place& place) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (!name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), fits)) return;
  throw InputError(
      place, fmt::format("invalid name of a robot: expected up to {1} letters, digits, _ and -, got “{0}”",
                         name, kLongestName));
}

Fleet read_fleet(const fs::path& file) {
  const std::string text = read_file(file);
  return read_as(FileKind::fleet, text, file.string(), [&] { return parse_fleet(text, file); });
}

Fleet parse_fleet(std::string_view text, const fs::path& file) {
  const ConfigValue root = parse_toml(text, file.string());
  TableReader reader(root, file.filename().string());
  Fleet fleet;
  fleet.file = file.string();
  fleet.map = reader.string("map", "");
  if (is_path(fleet.map)) fleet.map = named_path(file.parent_path(), fleet.map, root.find("map")->place);
  const ConfigValue* tables = reader.find("agent");
  reader.finish();
  if (!tables || tables->kind != ConfigValue::Kind::array || tables->items.empty())
    throw InputError({file.string(), 0, 0},
                     "the fleet has no robots: expected a table [[agent]] for each robot");
  if (tables->items.size() > result::kMostAgents)
    throw InputError(tables->items[result::kMostAgents].place,
                     fmt::format("too many robots: expected at most {}, got {}", result::kMostAgents,
                                 tables->items.size()));
  for (const ConfigValue& table : tables->items) {
    Member member = MemberReader(table, file.parent_path()).member();
    if (const Member* other = fleet.find(member.name))
      throw InputError(table.find("name")->place,
                       fmt::format("name: {} is already the name of the robot on line {}", member.name,
                                   other->place.line));
    fleet.members.push_back(std::move(member));
  }
  return fleet;
}

std::string runner_of(const std::vector<std::string>& targets) {
  for (const char* target : {"stm32", "avr"})
    if (std::find(targets.begin(), targets.end(), target) != targets.end()) return target;
  return "host";
}

ChosenFleet choose(Fleet& fleet) {
  ChosenFleet all;
  std::vector<std::string> targets;
  for (Member& member : fleet.members) {
    try {
      member.launch.map = fleet.map;
      Chosen chosen = choose(member.launch);
      if (all.members.empty()) fleet.map = chosen.map.path.string();
      if (!all.members.empty()) chosen.map = all.members.front().map;
      targets.push_back(chosen.target);
      all.members.push_back(std::move(chosen));
    } catch (const InputError& error) {
      blame(member, error);
    }
  }
  all.runner = runner_of(targets);
  return all;
}

PreparedFleet prepare(Launcher& launcher, const Fleet& fleet, ChosenFleet chosen,
                      const wire::RunRequest& common, const Describe& describe, const wire::Hello& runner) {
  std::map<std::string, wire::RobotInfo> described;
  const Describe once = [&](const std::string& robot) {
    const auto known = described.find(robot);
    return known != described.end() ? known->second : described.emplace(robot, describe(robot)).first->second;
  };
  PreparedFleet all;
  all.request = common;
  for (std::size_t i = 0; i < fleet.members.size(); ++i) {
    const Member& member = fleet.members[i];
    try {
      all.members.push_back(launcher.prepare(member.launch, std::move(chosen.members[i]), once, runner));
    } catch (const InputError& error) {
      blame(member, error);
    }
    const Prepared& ready = all.members.back();
    const wire::RunRequest& own = member.launch.request;
    wire::AgentRequest agent{member.name, ready.target, ready.request.image, ready.request.robot, own.start,
                             own.goal,    own.clock_ns, own.script,          own.script_file};
    if (i > 0) {
      all.request.agents.push_back(std::move(agent));
      continue;
    }
    wire::RunRequest& first = all.request;
    first.map = ready.request.map;
    first.name = agent.name, first.target = agent.target, first.image = agent.image,
    first.robot = agent.robot;
    first.start = agent.start, first.goal = agent.goal, first.clock_ns = agent.clock_ns;
    first.script = agent.script, first.script_file = agent.script_file;
  }
  return all;
}

std::vector<result::RunResult> results_of(result::RunResult first) {
  std::vector<result::RunResult> all = {result::RunResult{}};
  for (result::RunResult& other : first.others) all.push_back(std::move(other));
  first.others.clear();
  all.front() = std::move(first);
  return all;
}

result::RunResult whole_of(const result::RunResult& result, const wire::RunRequest& request) {
  if (result.others.empty()) return result;
  std::vector<const result::RunResult*> all = {&result};
  for (const result::RunResult& other : result.others) all.push_back(&other);
  const auto failed =
      std::find_if(all.begin(), all.end(), [](const result::RunResult* one) { return one->status != 0; });
  const auto number = static_cast<std::size_t>(failed - all.begin());
  result::RunResult whole = failed == all.end() ? result : **failed;
  whole.others.clear();
  whole.why = failed == all.end()
                  ? fmt::format("All {} robots reached their goals.", all.size())
                  : fmt::format("robot {}: {}", number == 0 ? request.name : request.agents[number - 1].name,
                                whole.why);
  whole.image_sha256 = result.image_sha256;
  whole.robot_sha256 = result.robot_sha256;
  whole.serial.clear();
  whole.shown.clear();
  result::Metrics& sum = whole.metrics;
  sum.distance_m = sum.energy_j = sum.energy_back_j = 0.0;
  sum.collisions = 0;
  for (const result::RunResult* one : all) {
    whole.time_s = std::max(whole.time_s, one->time_s);
    whole.serial += one->serial;
    whole.shown += one->shown;
    sum.distance_m += one->metrics.distance_m;
    sum.energy_j += one->metrics.energy_j;
    sum.energy_back_j += one->metrics.energy_back_j;
    sum.collisions += one->metrics.collisions;
  }
  return whole;
}

InputError with_place(const Fleet& fleet, const InputError& error) {
  if (!error.place().file.empty()) return error;
  for (const Member& member : fleet.members)
    if (error.message().starts_with(fmt::format("robot {}: ", member.name)) ||
        error.message().starts_with(fmt::format("robot {} starts ", member.name)))
      return {member.place, error.message()};
  return error;
}

}  // namespace robosim::launch
