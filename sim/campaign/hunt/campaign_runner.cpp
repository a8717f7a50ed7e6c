#include "sim/campaign/hunt/campaign_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/build/source.h"
#include "sim/campaign/check/checks_file.h"
#include "sim/campaign/hunt/input_dictionary.h"
#include "sim/campaign/hunt/stimuli.h"
#include "sim/campaign/rerun/line_counts.h"
#include "sim/launch/trust.h"
#include "sim/map/map.h"
#include "sim/map/network.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

/// The default maps: a loop, and a tree for sketches that navigate.
constexpr const char* kGuesses[] = {"oval", "a"};
constexpr std::size_t kMostWords = 60;

/// Returns the number of independent cycles of the line, but at most 3.
int cycles_of(const map::Map& map) {
  int nodes = 0, links = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!map::is_line(map.cells[i])) continue;
    ++nodes;
    const unsigned around = map::line_neighbours(map, map.cell_at(i));
    links += static_cast<int>(map::has(around, map::Direction::east)) +
             static_cast<int>(map::has(around, map::Direction::south));
  }
  return std::clamp(links - nodes + 1, 0, 3);
}

}  // namespace

CampaignRunner::CampaignRunner(const HuntOptions& options, launch::Listener listener)
    : work_(build::Cache(build::cache_folder())),
      pool_(options.jobs),
      script_(launch::scenario_text(options.each)) {
  space_.for_ms =
      static_cast<int>(std::min<std::int64_t>(options.each.request.for_ns / 1'000'000, 3'600'000));
  const wire::RunRequest& each = options.each.request;
  options_ = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", options.seed, each.for_ns, each.goal, each.start,
                         each.profile, options.only_maps);
  prepare(options, std::move(listener));
  look_at_maps(options);
  look_at_sketch();
  space_.assertions = text_assertions_in(prepared_.front().sketch.folder / "checks.toml");
}

void CampaignRunner::prepare(const HuntOptions& options, launch::Listener listener) {
  client::Runner describer("host");
  version_ = describer.hello().version;
  const launch::Describe describe = [&](const std::string& name) { return describer.describe_robot(name); };
  launch::Launcher launcher(std::move(listener));
  launch::Launch launch = launch::launch_of(options.each);
  launch.sketch = options.sketch;
  launch.robot = options.robot;
  if (!options.maps.empty()) launch.map = options.maps.front();
  const launch::SketchChoice sketch = launch::choose_sketch(options.sketch, options.each.environment);
  std::vector<std::string> targets = options.targets;
  if (targets.empty()) {
    targets.push_back(launch::chip_target(launch, describe));
    if (sketch.elf_target.empty() && targets.front() != "host") targets.push_back("host");
  }
  // With a chip and the host as targets, adds a build for the host without checks. Runs on the chip are
  // compared with runs of that build.
  const bool has_twin = targets.size() > 1 && targets.front() != "host" &&
                        std::find(targets.begin(), targets.end(), "host") != targets.end();
  for (const std::string& target : targets) {
    for (const bool checked : {false, true}) {
      // Skips builds with checks for a finished image and for the STM32. If there are several targets, skips
      // the host's build without checks.
      if (checked && (!sketch.elf_target.empty() || target == "stm32")) continue;
      if (!checked && target == "host" && targets.size() > 1) continue;
      launch.target = target;
      launch.sanitize = checked;
      try {
        prepared_.push_back(launcher.prepare(launch, choose(launch), describe, describer.hello()));
        space_.builds.push_back({target, checked});
      } catch (const build::CompileError&) {
        if (prepared_.empty()) throw;
        left_out_.push_back(fmt::format("{}{}: the sketch does not compile for this target", target,
                                        checked ? ", with checks" : ""));
      }
    }
  }
  if (has_twin) {
    launch.target = "host";
    launch.sanitize = false;
    try {
      prepared_.push_back(launcher.prepare(launch, choose(launch), describe, describer.hello()));
      space_.host_counterpart = space_.builds.size();
      space_.builds.push_back({"host", false});
    } catch (const build::CompileError&) {
      // The compile error for the host has already been reported.
    }
  }
  look_at_robot(options, describer);
}

void CampaignRunner::look_at_robot(const HuntOptions&, client::Runner& describer) {
  const RobotName name = parse_robot_name(prepared_.front().request.robot);
  board_ = name.board;
  space_.robot = launch::is_path(name.robot) ? fs::absolute(name.robot).string() : name.robot;
  robot_ = prepared_.front().robot_info;
  space_.figures =
      random_worlds::figures_of(describer.describe_robot(name.robot, true).text, robot_.file, 1.0);
  for (const auto& sensor : robot_.sensors) space_.parts.sensors.push_back(sensor.name);
  for (const auto& part : robot_.parts) {
    if (part.type == "motor") space_.parts.motors.push_back(part.name);
    if (part.type == "button") space_.buttons.push_back(part.name);
    if (part.type == "radio" || part.type == "ir-receiver" || part.type == "bluetooth")
      space_.listeners.emplace_back(part.name, part.type);
  }
}

void CampaignRunner::look_at_maps(const HuntOptions& options) {
  const launch::Prepared& first = prepared_.front();
  maps_are_given_ = !options.maps.empty() || first.map.name != kGuesses[0];
  std::vector<std::string> names = options.maps;
  if (names.empty()) names = {first.map.path.string()};
  if (!maps_are_given_) names.assign(std::begin(kGuesses), std::end(kGuesses));
  const std::string& goal = options.each.request.goal;
  space_.draws_maps = !options.only_maps && options.each.request.start.empty();
  for (const std::string& name : names) {
    const launch::Choice choice = launch::choose_map(name, first.sketch.folder);
    const map::Map map = map::read_map(choice.path);
    HuntSpace::Map& known = space_.maps.emplace_back();
    known.name = name;
    known.goal = goal;
    known.cell_mm = map.cell_m * 1000.0;
    known.corner_mm = map.corner_m * 1000.0;
    map_files_.push_back(choice.path.string());
    known.line = cells_with_line(map);
    const bool plain =
        map.course.paths.empty() && !map.image && map.lights.empty() && !map.light_line && !map.raster;
    if (!plain) continue;
    const bool laps = map::trace_network(map, map::default_start(map)).has_laps();
    const std::string& by_map = goal.empty() ? map.goal : goal;
    known.tracks = laps && (by_map.empty() || by_map.starts_with("laps"));
    known.networks = !laps && (by_map.empty() || by_map == "tour") && known.corner_mm == 0.0;
    known.cycles = cycles_of(map);
  }
}

void CampaignRunner::look_at_sketch() {
  const launch::SketchChoice& choice = prepared_.front().sketch;
  std::vector<std::string> words;
  bool hears = false;
  if (choice.elf_target.empty()) {
    const build::Sketch sketch =
        build::read_sketch(choice.path, {choice.project.sources, choice.project.includes, {}});
    for (const auto* files : {&sketch.inos, &sketch.sources, &sketch.headers})
      for (const std::string& file : *files) {
        const std::string text = read_file(sketch.folder / file);
        hears = hears || reads_input(text);
        space_.uses_eeprom = space_.uses_eeprom || (uses_eeprom(text) && prepared_.front().target != "stm32");
        add_words(text, words);
      }
  }
  if (!hears && space_.listeners.empty()) return;
  space_.words = {"0",     "1",     "2",   "3",   "4",    "7",     "10",
                  "99",    "100",   "255", "300", "1000", "32768", "65537",
                  "65538", "99999", "-1",  "x",   "?",    " ",     "the quick brown fox 12"};
  const std::size_t others = space_.words.size();
  std::set<std::string> known(space_.words.begin(), space_.words.end());
  for (const std::string& word : words)
    if (space_.words.size() < kMostWords && may_be_sent(word) && known.insert(word).second)
      space_.words.push_back(word);
  space_.own_words = space_.words.size() - others;
}

std::string CampaignRunner::fingerprint() const {
  std::string all = version_ + "\n" + options_ + script_ + robot_.sha256;
  for (const launch::Prepared& run : prepared_) all += "\n" + run.target + sha256_of_file(run.request.image);
  for (const std::string& map : map_files_) all += "\n" + map::sha256_of_map(map);
  for (const TextAssertion& assertion : space_.assertions)
    all += fmt::format("\n{} {}", static_cast<int>(assertion.when), assertion.text());
  return sha256(all);
}

void CampaignRunner::keep_maps(const std::vector<std::size_t>& maps) {
  std::vector<HuntSpace::Map> kept;
  std::vector<std::string> files;
  for (std::size_t map = 0; map < space_.maps.size(); ++map)
    if (std::find(maps.begin(), maps.end(), map) == maps.end()) left_maps_.push_back(space_.maps[map].name);
  for (const std::size_t map : maps) {
    kept.push_back(space_.maps[map]);
    files.push_back(map_files_[map]);
  }
  space_.maps = std::move(kept);
  map_files_ = std::move(files);
}

wire::RunRequest CampaignRunner::request_of(const TestCase& test_case, const std::string& folder) const {
  wire::RunRequest request = prepared_[test_case.build].request;
  request.seed = test_case.seed;
  request.detect = !space_.builds[test_case.build].checked;  // checks change the timing
  request.clock_ns = test_case.clock_ms * 1'000'000;
  request.for_ns = static_cast<std::int64_t>(test_case.for_s * 1000.0) * 1'000'000;
  request.script = script_of(test_case);
  request.script_file = "the hunt's script";
  request.map = map_files_[test_case.map];
  request.goal = test_case.drawn() ? "" : space_.maps[test_case.map].goal;
  if (!test_case.to_goal) request.goal = "none";
  std::error_code none;
  fs::create_directories(folder, none);
  if (const std::string map = map_text(test_case, space_); !map.empty()) {
    request.map = (fs::path(folder) / "world.map").string();
    write_file(request.map, map);
  }
  if (const std::string robot = robot_text(test_case, space_); !robot.empty()) {
    const std::string file = (fs::path(folder) / "robot.toml").string();
    write_file(file, robot);
    request.robot = board_.empty() ? file : robot_with_board(file, board_);
  }
  return request;
}

wire::RunRequest CampaignRunner::request_of_all(const std::vector<TestCase>& test_cases, const Task& task,
                                                const std::string& folder) const {
  const TestCase& first = test_cases[task.first];
  if (task.count == 1) return request_of(first, folder);
  TestCase start = first;
  start.stimuli.pop_back();
  wire::RunRequest request = request_of(start, folder);
  wire::Ways& ways = request.ways.emplace();
  ways.after = first.branch_point.after;
  if (ways.after.empty()) ways.at_ns = std::int64_t{first.branch_point.at_ms} * kMillisecond;
  for (std::size_t i = 0; i < task.count; ++i)
    ways.scripts.push_back(script_line(test_cases[task.first + i].stimuli.back()));
  return request;
}

std::vector<CampaignRunner::Task> CampaignRunner::tasks_of(const std::vector<TestCase>& test_cases) const {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < test_cases.size(); ++i) {
    const bool part = i > 0 && test_cases[i].family > 0 && test_cases[i].family == test_cases[i - 1].family &&
                      test_cases[i].for_s == test_cases[i - 1].for_s &&
                      space_.builds[test_cases[i].build].target != "host";
    if (part)
      ++tasks.back().count;
    else
      tasks.push_back({i, 1});
  }
  return tasks;
}

bool CampaignRunner::run(const std::vector<TestCase>& test_cases,
                         std::vector<std::optional<result::RunResult>>& results,
                         std::vector<std::vector<std::string>>* ran) {
  results.assign(test_cases.size(), std::nullopt);
  if (ran) ran->assign(test_cases.size(), {});
  const std::vector<Task> tasks = tasks_of(test_cases);
  std::vector<std::size_t> alone;  // test cases of families that could not share a run
  const auto counters = [&](std::size_t t) { return work_.path() / std::to_string(t) / "lines"; };
  const auto keep = [&](std::size_t i, result::RunResult&& result, const fs::path& lines) {
    results[i] = std::move(result);
    if (!ran) return;
    for (const auto& [place, count] : take_line_counts(lines))
      if (count > 0.0) (*ran)[i].push_back(fmt::format("ran {}:{}", place.first, place.second));
  };
  const bool whole = pool_.run(
      {tasks.size(),
       [&](std::size_t t) {
         const HuntSpace::Build& build = space_.builds[test_cases[tasks[t].first].build];
         const std::string folder = (work_.path() / std::to_string(t)).string();
         client::Task task{build.target, request_of_all(test_cases, tasks[t], folder)};
         if (ran && build.target != "host" && !build.checked) task.request.counters = counters(t).string();
         return task;
       },
       [&](std::size_t t, client::Answer&& answer) {
         const std::size_t first = tasks[t].first;
         if (auto* result = std::get_if<result::RunResult>(&answer)) {
           std::vector<result::RunResult> others = std::move(result->ways);
           keep(first, std::move(*result), counters(t));
           for (std::size_t i = 0; i < others.size() && i + 1 < tasks[t].count; ++i)
             keep(first + i + 1, std::move(others[i]), fmt::format("{}.{}", counters(t).string(), i + 2));
           return;
         }
         const auto& failure = std::get<client::Failure>(answer);
         if (failure.kind == client::Failure::Kind::tool) throw ToolMissing(failure.message);
         if (failure.kind == client::Failure::Kind::internal) throw wire::RunnerError(failure.message);
         if (tasks[t].count > 1) {
           for (std::size_t i = 0; i < tasks[t].count; ++i) alone.push_back(first + i);
         } else if (refused_++ == 0) {
           refusal_ = failure.message;
         }
       },
       {}});
  if (!whole || alone.empty()) return whole;
  std::vector<TestCase> others;
  for (const std::size_t i : alone) {
    others.push_back(test_cases[i]);
    others.back().family = 0;
  }
  std::vector<std::optional<result::RunResult>> later;
  std::vector<std::vector<std::string>> ran_later;
  if (!run(others, later, ran ? &ran_later : nullptr)) return false;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    results[alone[i]] = std::move(later[i]);
    if (ran) (*ran)[alone[i]] = std::move(ran_later[i]);
  }
  return true;
}

}  // namespace robosim::campaign
