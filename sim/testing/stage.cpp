#include "sim/testing/stage.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <map>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/grid/map.h"
#include "sim/grid/true_graph.h"
#include "sim/launch/fit_robot.h"
#include "sim/testing/coverage.h"

namespace robosim::testing {
namespace fs = std::filesystem;

namespace {

std::map<std::string, std::vector<std::unique_ptr<client::Runner>>>& idle_runners() {
  static std::map<std::string, std::vector<std::unique_ptr<client::Runner>>> runners;
  return runners;
}

bool is_text(const std::string& value) { return value.find('\n') != std::string::npos; }
bool is_path(const std::string& name) { return name.find_first_of("/.") != std::string::npos; }
bool is_elf(const std::string& sketch) { return fs::path(sketch).extension() == ".elf"; }

fs::path write_scratch(Stage& stage, const std::string& name, const std::string& text) {
  if (stage.scratch.empty()) {
    std::string folder = (fs::temp_directory_path() / "robosim-test-XXXXXX").string();
    if (!::mkdtemp(folder.data())) throw InputError({folder}, "no folder can be made there");
    stage.scratch = folder;
  }
  write_file(stage.scratch / name, text);
  return stage.scratch / name;
}

/// The only file with that ending beside the sketch; empty if there is none, or more than one.
fs::path only_one(const fs::path& folder, const char* ending) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ending) found.push_back(entry.path());
  return found.size() == 1 ? found[0] : fs::path();
}

void choose_map(const Trial& trial, const fs::path& folder, Stage& stage) {
  stage.map = trial.map.empty() ? only_one(folder, ".map").string() : trial.map;
  if (stage.map.empty()) stage.map = "oval";
  stage.map_is_text = is_text(stage.map);
  if (stage.map_is_text) stage.map = write_scratch(stage, "map.map", stage.map).string();
  stage.request.map = grid::find_map(stage.map).string();
}

void choose_robot(const Trial& trial, const fs::path& folder, client::Runner& runner, Stage& stage) {
  std::error_code error;
  stage.robot_name = trial.robot;
  if (stage.robot_name.empty())
    stage.robot_name =
        fs::exists(folder / "robot.toml", error) ? (folder / "robot.toml").string() : std::string("uno5");
  stage.robot_is_text = is_text(stage.robot_name);
  if (stage.robot_is_text) stage.robot_name = write_scratch(stage, "robot.toml", trial.robot).string();
  launch::FittedRobot fitted =
      launch::fit_robot(stage.robot_name, build::boards_of(trial.target),
                        [&](const std::string& name) { return runner.describe_robot(name); });
  stage.robot = std::move(fitted.info);
  stage.request.robot = stage.robot_name = fitted.robot;
}

/// Sketches are compiled once a process; after that even the cache on the disk is not asked.
const Built& built_for(const Trial& trial, const fs::path& sketch, const std::string& board) {
  static std::map<std::string, Built> built;
  std::string key = fmt::format("{}\n{}\n{}", sketch.string(), board, trial.target);
  for (const std::string& folder : trial.libraries) key += "\n" + folder;
  const auto known = built.find(key);
  if (known != built.end()) return known->second;
  const BoardSpec* spec = find_board(board.c_str());
  if (!spec) throw InputError("the robot's board is unknown: " + board);
  build::Request request{sketch, *spec, trial.target, {}, build::Warnings::standard};
  for (const std::string& folder : trial.libraries) request.libraries.emplace_back(folder);
  request.coverage = !coverage_folder(trial.target).empty();
  return built.emplace(key, Built{request, build::build(request)}).first->second;
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
  if (!is_elf(trial.sketch)) return trial.target;
  // Byte 18 of an ELF file's header names the machine: 40 = ARM, 83 = AVR.
  const std::string file = read_file(trial.sketch);
  const int machine = file.size() > 18 ? static_cast<unsigned char>(file[18]) : 0;
  if (machine != 83 && machine != 40)
    throw InputError({trial.sketch}, "is no program for a chip that Robosim knows");
  return machine == 83 ? "avr" : "stm32";
}

Stage set_stage(const Trial& trial, client::Runner& runner) {
  Stage stage;
  stage.sketch = trial.sketch;
  stage.target = trial.target;
  stage.libraries = trial.libraries;
  const fs::path sketch = is_elf(trial.sketch) ? fs::path(trial.sketch) : build::find_sketch(trial.sketch);
  std::error_code error;
  const fs::path folder = fs::is_directory(sketch, error) ? sketch : sketch.parent_path();
  const fs::path whole = fs::absolute(sketch).lexically_normal();  // "." has a name, too
  stage.sketch_title = (whole.has_filename() ? whole : whole.parent_path()).stem().string();
  if (!is_path(trial.sketch)) stage.sketch_title = trial.sketch;
  choose_map(trial, folder, stage);
  choose_robot(trial, folder, runner, stage);

  wire::RunRequest& request = stage.request;
  if (is_elf(trial.sketch)) {
    request.image = trial.sketch;
  } else {
    const Built& built = built_for(trial, sketch, stage.robot.board.name);
    request.image = built.image.image.string();
    if (built.request.coverage) {
      stage.counted = &built;
      request.counters = new_counter_file(coverage_folder(trial.target));
    }
  }
  request.start = trial.start;
  request.goal = trial.goal;
  request.for_ns = trial.limit.count();
  request.seed = trial.seed;
  request.profile = trial.profile;
  request.clock_ns = trial.clock_start.count();
  request.script = trial.script;
  request.script_file = "the Trial's script";
  request.samples_every_ns = 10'000'000;
  request.serial = request.notes = true;
  return stage;
}

Graph graph_of_floor(const wire::RunRequest& request) {
  const grid::Map map = grid::read_map(request.map);
  const grid::TrueGraph truth = grid::true_graph(
      map, request.start.empty() ? grid::default_start(map) : grid::parse_start(map, request.start));
  const int stations = static_cast<int>(truth.stations.size());
  const auto end_of = [&](const grid::Arm& arm) -> Graph::End {
    if (arm.behind == grid::Arm::Behind::station) return {arm.id - 1, 0};
    if (arm.behind == grid::Arm::Behind::junction) return {stations + arm.id - 1, arm.slot};
    return {};
  };
  Graph graph;
  for (const grid::GraphStation& station : truth.stations) {
    graph.nodes.emplace_back();
    if (station.arm.behind != grid::Arm::Behind::nothing)
      graph.nodes.back().arms.push_back(end_of(station.arm));
  }
  for (const grid::GraphJunction& junction : truth.junctions) {
    graph.nodes.emplace_back();
    for (const grid::Arm& arm : junction.arms) graph.nodes.back().arms.push_back(end_of(arm));
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
