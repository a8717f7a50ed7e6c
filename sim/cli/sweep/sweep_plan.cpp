#include "sim/cli/sweep/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/cli/run/run_command.h"
#include "sim/launch/image.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 8;

std::string time_word(std::int64_t ns) {
  if (ns % 1'000'000'000 == 0) return fmt::format("{}s", ns / 1'000'000'000);
  if (ns % 1'000'000 == 0) return fmt::format("{}ms", ns / 1'000'000);
  return fmt::format("{}ns", ns);
}

/// The options of `robosim run` that differ from its defaults.
std::string options_of(const RunArguments& each) {
  const RunArguments usual;
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    text += fmt::format(" {} {}", option, shell_word(value));
  };
  if (!each.start.empty()) add("--start", each.start);
  if (!each.goal.empty()) add("--goal", each.goal);
  if (each.for_ns != usual.for_ns) add("--for", time_word(each.for_ns));
  if (each.clock_ns != usual.clock_ns) add("--clock", time_word(each.clock_ns));
  if (each.profile != usual.profile) add("--profile", each.profile);
  if (!each.script.empty()) add("--script", each.script);
  for (const std::string& send : each.send) add("--send", send);
  for (const std::string& folder : each.libraries) add("--libraries", folder);
  if (each.sanitize) text += " --sanitize";
  return text;
}

/// All that runs share, one thing a line.
std::string conditions_of(const wire::RunRequest& r, const std::string& version) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", version, r.start, r.goal, r.for_ns, r.clock_ns, r.profile,
                     r.script);
}

}  // namespace

class SweepSupplies {
 public:
  SweepSupplies(launch::Progress& progress, SweepPlanner::Says says) : progress_(progress), says_(says) {}

  launch::Choice said(launch::Choice choice) {
    say(choice.announcement);
    return choice;
  }

  launch::Carrier carrier(const launch::Choice& robot_choice, const std::string& target) {
    launch::Carrier fitted =
        fit_to_target(robot_choice, target, [this](const std::string& name) { return robot(name); });
    say(fitted.announcement);
    return fitted;
  }

  const std::string& version() const { return describer_->hello().version; }

  const build::Image& image(const launch::SketchChoice& sketch, const build::Request& request) {
    std::string key = fmt::format("{}\n{}\n{}\n{}", sketch.path.string(), request.board.name, request.target,
                                  request.sanitize);
    for (const fs::path& folder : request.libraries) key += "\n" + folder.string();
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    return images_.emplace(key, image_of(sketch, request, progress_, says_.warnings)).first->second;
  }

  const std::string& hash_of_file(const std::string& path) {
    const auto known = hashes_.find(path);
    if (known != hashes_.end()) return known->second;
    return hashes_.emplace(path, sha256_of_file(path)).first->second;
  }

 private:
  void say(const std::string& announcement) {
    if (says_.choices && !announcement.empty() && announced_.insert(announcement).second)
      fmt::print(stderr, "robosim: {}\n", announcement);
  }

  const wire::RobotInfo& robot(const std::string& name) {
    const auto known = robots_.find(name);
    if (known != robots_.end()) return known->second;
    if (!describer_) describer_.emplace("host");  // a robot is the same for all targets
    return robots_.emplace(name, describer_->describe_robot(name)).first->second;
  }

  launch::Progress& progress_;
  SweepPlanner::Says says_;
  std::set<std::string> announced_;
  std::optional<client::Runner> describer_;
  std::map<std::string, wire::RobotInfo> robots_;
  std::map<std::string, build::Image> images_;
  std::map<std::string, std::string> hashes_;
};

namespace {

/// Gives the combinations of one sweep.
class Combiner {
 public:
  Combiner(const SweepArguments& arguments, SweepSupplies& supplies)
      : arguments_(arguments), supplies_(supplies), script_(scenario_text(arguments.each)) {}

  void add_sketch(const std::string& name, std::vector<Combination>& combinations) {
    const launch::SketchChoice sketch = launch::choose_sketch(name);
    for (const std::string& map : or_default(arguments_.maps)) {
      for (const std::string& robot : or_default(arguments_.robots)) {
        for (const std::string& target : targets_of(sketch))
          combinations.push_back(combine(sketch, map, robot, target));
      }
    }
  }

 private:
  static std::vector<std::string> or_default(const std::vector<std::string>& names) {
    return names.empty() ? std::vector<std::string>{""} : names;
  }

  std::vector<std::string> targets_of(const launch::SketchChoice& sketch) const {
    std::vector<std::string> targets = arguments_.targets;
    if (targets.empty()) targets.push_back(sketch.elf_target.empty() ? "host" : sketch.elf_target);
    for (const std::string& target : targets) {
      launch::check_target(target);
      if (arguments_.each.sanitize) build::check_can_sanitize(target);
      if (!sketch.elf_target.empty() && target != sketch.elf_target) {
        throw InputError({sketch.name, 0, 0}, fmt::format("is for the target {}, and --target asks for {}",
                                                          sketch.elf_target, target));
      }
    }
    return targets;
  }

  const build::Image& image(const launch::SketchChoice& sketch, const BoardSpec& board,
                            const std::string& target) {
    build::Request request{sketch.path, board, target};
    for (const std::string& folder : arguments_.each.libraries) request.libraries.emplace_back(folder);
    request.sanitize = arguments_.each.sanitize;
    return supplies_.image(sketch, request);
  }

  /// Map and robot as the user named them, or empty.
  Combination combine(const launch::SketchChoice& sketch, const std::string& map_word,
                      const std::string& robot_word, const std::string& target) {
    const launch::Choice map = supplies_.said(launch::choose_map(map_word, sketch.folder));
    const launch::Carrier carrier =
        supplies_.carrier(supplies_.said(launch::choose_robot(robot_word, sketch.folder, target)), target);
    const build::Image& made = image(sketch, launch::board_of(carrier.info), target);
    Combination c;
    c.task.target = target;
    wire::RunRequest& request = c.task.request;
    request.image = made.image.string();
    request.map = map.path.string();
    request.robot = carrier.robot.path.string();
    request.start = arguments_.each.start;
    request.goal = arguments_.each.goal;
    request.for_ns = arguments_.each.for_ns;
    request.clock_ns = arguments_.each.clock_ns;
    request.profile = arguments_.each.profile;
    request.script = script_;
    request.script_file = arguments_.each.script.empty() ? "--send" : arguments_.each.script;
    c.inputs = {supplies_.version(), target,
                sketch.name,         map.name,
                carrier.robot.name,  made.sketch_sha256,
                made.compiler,       arguments_.each.sanitize};
    c.image_sha256 = supplies_.hash_of_file(request.image);
    c.map_sha256 = supplies_.hash_of_file(request.map);
    c.robot_sha256 = carrier.info.sha256;
    const std::string conditions = sha256(conditions_of(request, c.inputs.robosim));
    c.fingerprint.parts = {c.image_sha256.substr(0, kDigits), c.map_sha256.substr(0, kDigits),
                           c.robot_sha256.substr(0, kDigits), conditions.substr(0, kDigits)};
    c.replay = "robosim run " + shell_word(sketch.name);
    if (!map_word.empty()) c.replay += " --map " + shell_word(map_word);
    if (!robot_word.empty()) c.replay += " --robot " + shell_word(robot_word);
    if (target != "host" && sketch.elf_target.empty()) c.replay += " --target " + target;
    c.replay += options_of(arguments_.each);
    return c;
  }

  const SweepArguments& arguments_;
  SweepSupplies& supplies_;
  std::string script_;
};

}  // namespace

std::string Fingerprint::text() const { return fmt::format("{}", fmt::join(parts, "-")); }

std::string Combination::text() const {
  return fmt::format("{} on {} with {}, target {}", inputs.sketch, inputs.map, inputs.robot, inputs.target);
}

client::Task SweepPlan::task_of(std::size_t run) const {
  client::Task task = combination_of(run).task;
  task.request.seed = seed_of(run);
  return task;
}

SweepPlanner::SweepPlanner(launch::Progress& progress, Says says)
    : supplies_(std::make_unique<SweepSupplies>(progress, says)) {}

SweepPlanner::~SweepPlanner() = default;

SweepPlan SweepPlanner::plan(const SweepArguments& arguments) {
  SweepPlan plan;
  plan.first_seed = arguments.first_seed;
  plan.seeds = arguments.last_seed - arguments.first_seed + 1;
  Combiner combiner(arguments, *supplies_);
  if (arguments.sketches.empty()) combiner.add_sketch("", plan.combinations);
  for (const std::string& sketch : arguments.sketches) combiner.add_sketch(sketch, plan.combinations);
  return plan;
}

std::string replay_command(const Combination& combination, std::uint64_t seed) {
  return fmt::format("{} --seed {}", combination.replay, seed);
}

}  // namespace robosim::cli
