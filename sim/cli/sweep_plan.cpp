#include "sim/cli/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/image.h"
#include "sim/cli/names.h"
#include "sim/cli/run_command.h"

namespace robosim::cli {
namespace {

constexpr std::size_t kDigits = 8;

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  constexpr const char* kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./,:=+-@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

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
std::string conditions_of(const client::RunRequest& r, const std::string& version) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", version, r.start, r.goal, r.for_ns, r.clock_ns, r.profile,
                     r.script);
}

/// Collects what combinations share, so that nothing is compiled, read or said twice.
class Planner {
 public:
  Planner(const SweepArguments& arguments, Progress& progress)
      : arguments_(arguments), progress_(progress), script_(scenario_text(arguments.each)) {}

  void add_sketch(const std::string& name, std::vector<Combination>& combinations) {
    const SketchChoice sketch = choose_sketch(name);
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

  Choice said(Choice choice) {
    if (!choice.announcement.empty() && announced_.insert(choice.announcement).second)
      fmt::print(stderr, "robosim: {}\n", choice.announcement);
    return choice;
  }

  std::vector<std::string> targets_of(const SketchChoice& sketch) const {
    std::vector<std::string> targets = arguments_.targets;
    if (targets.empty()) targets.push_back(sketch.elf_target.empty() ? "host" : sketch.elf_target);
    for (const std::string& target : targets) {
      check_target(target);
      if (arguments_.each.sanitize) sketch::check_can_sanitize(target);
      if (!sketch.elf_target.empty() && target != sketch.elf_target) {
        throw InputError({sketch.name, 0, 0}, fmt::format("is for the target {}, and --target asks for {}",
                                                          sketch.elf_target, target));
      }
    }
    return targets;
  }

  const client::RobotInfo& robot(const std::string& path) {
    const auto known = robots_.find(path);
    if (known != robots_.end()) return known->second;
    if (!describer_) describer_.emplace("host");  // a robot is the same for all targets
    return robots_.emplace(path, describer_->describe_robot(path)).first->second;
  }

  const sketch::Image& image(const SketchChoice& sketch, const BoardSpec& board, const std::string& target) {
    const auto key = std::make_tuple(sketch.path.string(), std::string(board.name), target);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    sketch::Request request{sketch.path, board, target};
    for (const std::string& folder : arguments_.each.libraries) request.libraries.emplace_back(folder);
    request.sanitize = arguments_.each.sanitize;
    return images_.emplace(key, image_of(sketch, request, progress_)).first->second;
  }

  const std::string& hash_of_file(const std::string& path) {
    const auto known = hashes_.find(path);
    if (known != hashes_.end()) return known->second;
    return hashes_.emplace(path, sha256_of_file(path)).first->second;
  }

  /// Map and robot as the user named them, or empty.
  Combination combine(const SketchChoice& sketch, const std::string& map_word, const std::string& robot_word,
                      const std::string& target) {
    const Choice map = said(choose_map(map_word, sketch.folder));
    const Choice robot_choice = said(choose_robot(robot_word, sketch.folder));
    const client::RobotInfo& info = robot(robot_choice.path.string());
    const sketch::Image& made = image(sketch, board_of(info), target);
    Combination c;
    c.task.target = target;
    client::RunRequest& request = c.task.request;
    request.image = made.image.string();
    request.map = map.path.string();
    request.robot = robot_choice.path.string();
    request.start = arguments_.each.start;
    request.goal = arguments_.each.goal;
    request.for_ns = arguments_.each.for_ns;
    request.clock_ns = arguments_.each.clock_ns;
    request.profile = arguments_.each.profile;
    request.script = script_;
    request.script_file = arguments_.each.script.empty() ? "--send" : arguments_.each.script;
    c.inputs = {describer_->hello().version,
                target,
                sketch.name,
                map.name,
                robot_choice.name,
                made.sketch_sha256,
                made.compiler,
                arguments_.each.sanitize};
    c.image_sha256 = hash_of_file(request.image);
    c.map_sha256 = hash_of_file(request.map);
    c.robot_sha256 = info.sha256;
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
  Progress& progress_;
  std::string script_;
  std::set<std::string> announced_;
  std::optional<client::Runner> describer_;
  std::map<std::string, client::RobotInfo> robots_;
  std::map<std::tuple<std::string, std::string, std::string>, sketch::Image> images_;
  std::map<std::string, std::string> hashes_;
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

SweepPlan plan_sweep(const SweepArguments& arguments, Progress& progress) {
  SweepPlan plan;
  plan.first_seed = arguments.first_seed;
  plan.seeds = arguments.last_seed - arguments.first_seed + 1;
  Planner planner(arguments, progress);
  if (arguments.sketches.empty()) planner.add_sketch("", plan.combinations);
  for (const std::string& sketch : arguments.sketches) planner.add_sketch(sketch, plan.combinations);
  return plan;
}

std::string replay_command(const Combination& combination, std::uint64_t seed) {
  return fmt::format("{} --seed {}", combination.replay, seed);
}

}  // namespace robosim::cli
