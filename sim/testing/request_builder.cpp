#include "sim/testing/request_builder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/launch/launch.h"
#include "sim/map/map.h"
#include "sim/map/true_graph.h"
#include "sim/testing/coverage.h"

namespace robosim::testing {
namespace fs = std::filesystem;

namespace {

std::map<std::string, std::vector<std::unique_ptr<client::Runner>>>& idle_runners() {
  static std::map<std::string, std::vector<std::unique_ptr<client::Runner>>> runners;
  return runners;
}

bool is_text(const std::string& value) { return value.find('\n') != std::string::npos; }

/// Returns the argument unchanged if it is a name or path. Otherwise writes the text to a file in `scratch`,
/// and returns the file's path. Creates the folder `scratch` if necessary.
std::string name_of(const std::string& name_or_text, const std::string& file, fs::path& scratch) {
  if (!is_text(name_or_text)) return name_or_text;
  if (scratch.empty()) {
    std::string folder = (fs::temp_directory_path() / "robosim-test-XXXXXX").string();
    if (!::mkdtemp(folder.data())) throw InputError({folder}, "cannot create a folder there");
    scratch = folder;
  }
  write_file(scratch / file, name_or_text);
  return (scratch / file).string();
}

constexpr std::int64_t kSamplesEvery_ns = 10'000'000;

/// Returns the sketch's name. For ".", this is the folder's name.
std::string title_of(const std::string& sketch, const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return launch::is_path(sketch) ? (whole.has_filename() ? whole : whole.parent_path()).stem().string()
                                 : sketch;
}

/// Returns the sketch, or its copy for robosim mutate. That command sets ROBOSIM_MUTANT="/sketch=/copy":
/// files of the first folder are read from the second.
std::string in_place_of(const std::string& sketch) {
  const char* words = std::getenv("ROBOSIM_MUTANT");
  const std::string_view mutant = words ? words : "";
  const std::size_t middle = mutant.find('=');
  if (middle == std::string_view::npos) return sketch;
  const fs::path within =
      fs::weakly_canonical(launch::choose_sketch(sketch).path).lexically_relative(mutant.substr(0, middle));
  if (within.empty() || *within.begin() == "..") return sketch;
  return (fs::path(mutant.substr(middle + 1)) / within).lexically_normal().string();
}

launch::SketchChoice choose_sketch(const Trial& trial) {
  if (trial.sketch.empty()) throw InputError("a Trial requires a sketch");
  return launch::choose_sketch(in_place_of(trial.sketch));
}

/// Returns the robosim command's argument that makes this choice.
std::string word_for(const launch::Choice& choice) {
  return launch::is_path(choice.name) ? choice.path.string() : choice.name;
}

/// Returns the launcher of this process, which compiles each sketch once. When a test uses the sketch again,
/// the launcher does not even read the cache on disk.
launch::Launcher& launcher() {
  static launch::Launcher launcher;
  return launcher;
}

}  // namespace

Borrowed::Borrowed(const std::string& target) : target_(target) {
  auto& idle = idle_runners()[target];
  if (idle.empty()) {
    runner_ = std::make_unique<client::Runner>(target);
  } else {
    runner_ = std::move(idle.back());
    idle.pop_back();
  }
}

Borrowed::~Borrowed() {
  if (sound_) idle_runners()[target_].push_back(std::move(runner_));
}

std::string target_of(const Trial& trial) {
  // "host" is the default target of a Trial, and counts as no choice.
  return launch::choose_target(trial.target == "host" ? "" : trial.target, choose_sketch(trial));
}

ResolvedTrial resolve_trial(const Trial& trial, client::Runner& runner) {
  ResolvedTrial resolved_trial;
  resolved_trial.sketch = trial.sketch;
  resolved_trial.target = trial.target;
  resolved_trial.libraries = trial.libraries;
  resolved_trial.map_is_text = is_text(trial.map);
  resolved_trial.robot_is_text = is_text(trial.robot);

  launch::Launch launch;
  launch.sketch = in_place_of(trial.sketch);
  launch.map = name_of(trial.map, "map.map", resolved_trial.scratch);
  launch.robot = name_of(trial.robot, "robot.toml", resolved_trial.scratch);
  launch.target = trial.target;
  launch.libraries = trial.libraries;
  launch::Chosen chosen = choose(launch);
  launch.count_lines = chosen.sketch.elf_target.empty() && !coverage_folder(trial.target).empty();
  wire::RunRequest& request = launch.request;
  if (launch.count_lines) request.counters = new_counter_file(coverage_folder(trial.target));
  request.start = trial.start;
  request.goal = trial.goal;
  request.for_ns = trial.limit.count();
  request.seed = trial.seed;
  request.profile = trial.profile;
  request.clock_ns = trial.clock_start.count();
  request.script = trial.script;
  request.script_file = "the Trial's script";
  request.samples_every_ns = kSamplesEvery_ns;
  request.serial = request.notes = true;
  request.detect = trial.detect;

  launch::Prepared run = launcher().prepare(
      launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
      runner.hello());
  resolved_trial.sketch_title = title_of(trial.sketch, run.sketch.path);
  resolved_trial.map = word_for(run.map);
  resolved_trial.robot_name = run.request.robot;
  resolved_trial.robot = std::move(run.robot_info);
  if (launch.count_lines) resolved_trial.counted.emplace(Built{std::move(run.wanted), std::move(run.image)});
  resolved_trial.request = std::move(run.request);
  return resolved_trial;
}

ResolvedFleetTrial resolve_fleet_trial(const FleetTrial& trial) {
  ResolvedFleetTrial all;
  launch::Fleet& fleet = all.fleet;
  if (!trial.file.empty() && !trial.robots.empty())
    throw InputError("a FleetTrial requires either a file of robots or the robots, got both");
  if (!trial.file.empty()) fleet = launch::read_fleet(trial.file);
  if (fleet.members.empty() && trial.robots.empty()) throw InputError("a FleetTrial requires robots");
  for (const FleetMember& robot : trial.robots) {
    launch::check_member_name(robot.name);
    if (fleet.find(robot.name)) throw InputError("two robots are named " + robot.name);
    if (robot.sketch.empty()) throw InputError("robot " + robot.name + " requires a sketch");
    launch::Member& member = fleet.members.emplace_back();
    member.name = robot.name;
    launch::Launch& launch = member.launch;
    launch.sketch = in_place_of(robot.sketch);
    launch.robot = name_of(robot.robot, robot.name + ".toml", all.scratch);
    launch.target = robot.target == "host" ? "" : robot.target;  // as in target_of()
    launch.libraries = robot.libraries;
    launch.request.start = robot.start;
    launch.request.goal = robot.goal;
    launch.request.clock_ns = robot.clock_start.count();
    launch.request.script = robot.script;
    launch.request.script_file = "the script of " + robot.name;
  }
  all.map_is_text = is_text(trial.map);
  if (!trial.map.empty()) fleet.map = name_of(trial.map, "map.map", all.scratch);
  all.chosen = launch::choose(fleet);
  return all;
}

std::vector<ResolvedTrial> resolve_trials(const FleetTrial& trial, ResolvedFleetTrial& all,
                                          client::Runner& runner) {
  wire::RunRequest common;
  common.for_ns = trial.limit.count();
  common.seed = trial.seed;
  common.profile = trial.profile;
  common.samples_every_ns = kSamplesEvery_ns;
  common.serial = common.notes = true;
  common.detect = trial.detect;
  launch::PreparedFleet run = launch::prepare(
      launcher(), all.fleet, std::move(all.chosen), common,
      [&](const std::string& name) { return runner.describe_robot(name); }, runner.hello());
  std::vector<ResolvedTrial> resolved_trials;
  for (std::size_t i = 0; i < run.members.size(); ++i) {
    launch::Prepared& one = run.members[i];
    const launch::Launch& named = all.fleet.members[i].launch;
    ResolvedTrial& resolved_trial = resolved_trials.emplace_back();
    resolved_trial.sketch = named.sketch;
    resolved_trial.target = one.target;
    resolved_trial.libraries = named.libraries;
    resolved_trial.sketch_title = title_of(named.sketch, one.sketch.path);
    resolved_trial.map = word_for(one.map);
    resolved_trial.map_is_text = all.map_is_text;
    resolved_trial.robot_is_text = !trial.robots.empty() && is_text(trial.robots[i].robot);
    resolved_trial.robot_name = one.request.robot;
    resolved_trial.robot = std::move(one.robot_info);
    resolved_trial.request = run.request;
    resolved_trial.request.start = named.request.start;  // start of this robot, for true_graph()
    Trial& alone = all.trials.emplace_back();
    alone.sketch = named.sketch;
    alone.map = fs::path(run.request.map).string();
    alone.robot = resolved_trial.robot_name;
    alone.target = one.target;
    alone.seed = trial.seed;
    alone.profile = trial.profile;
    alone.start = named.request.start;
    alone.goal = named.request.goal;
    alone.script = named.request.script;
    alone.limit = trial.limit;
    alone.detect = trial.detect;
    alone.clock_start = Duration(named.request.clock_ns);
    alone.libraries = named.libraries;
  }
  return resolved_trials;
}

Graph graph_of_floor(const wire::RunRequest& request) {
  const map::Map map = map::read_map(request.map);
  const map::TrueGraph truth = map::true_graph(
      map, request.start.empty() ? map::default_start(map) : map::parse_start(map, request.start));
  const int stations = static_cast<int>(truth.stations.size());
  const auto end_of = [&](const map::Arm& arm) -> Graph::End {
    if (arm.behind == map::Arm::Behind::station) return {arm.id - 1, 0};
    if (arm.behind == map::Arm::Behind::junction) return {stations + arm.id - 1, arm.slot};
    return {};
  };
  Graph graph;
  for (const map::GraphStation& station : truth.stations) {
    graph.nodes.emplace_back();
    if (station.arm.behind != map::Arm::Behind::nothing)
      graph.nodes.back().arms.push_back(end_of(station.arm));
  }
  for (const map::GraphJunction& junction : truth.junctions) {
    graph.nodes.emplace_back();
    for (const map::Arm& arm : junction.arms) graph.nodes.back().arms.push_back(end_of(arm));
  }
  return graph;
}

std::string what_lacks(const std::string& target) {
  try {
    const std::vector<std::string>& known = client::available_targets();
    if (std::find(known.begin(), known.end(), target) == known.end())
      return fmt::format("the target {} does not exist in this version of Robosim", target);
    const std::string tool = build::missing_tool(target);
    if (!tool.empty()) return tool;
    Borrowed runner(target);
    return "";
  } catch (const std::exception& problem) {
    return problem.what();
  }
}

bool is_required(const std::string& target) {
  const char* required = std::getenv("ROBOSIM_REQUIRE");
  return required && ("," + std::string(required) + ",").find("," + target + ",") != std::string::npos;
}

}  // namespace robosim::testing
