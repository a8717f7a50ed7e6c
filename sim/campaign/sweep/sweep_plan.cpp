#include "sim/campaign/sweep/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/build/sketch.h"
#include "sim/launch/fleet.h"
#include "sim/launch/trust.h"
#include "sim/map/map.h"

namespace robosim::campaign {
namespace {

constexpr std::size_t kDigits = 8;

std::string time_word(std::int64_t ns) {
  if (ns % 1'000'000'000 == 0) return fmt::format("{}s", ns / 1'000'000'000);
  if (ns % 1'000'000 == 0) return fmt::format("{}ms", ns / 1'000'000);
  return fmt::format("{}ns", ns);
}

/// Returns the options of `robosim run` that differ from its defaults.
std::string options_of(const launch::RunSettings& each) {
  const launch::RunSettings usual;
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    text += fmt::format(" {} {}", option, shell_word(value));
  };
  if (!each.request.start.empty()) add("--start", each.request.start);
  if (!each.request.goal.empty()) add("--goal", each.request.goal);
  if (each.request.for_ns != usual.request.for_ns) add("--for", time_word(each.request.for_ns));
  if (each.request.clock_ns != usual.request.clock_ns) add("--clock", time_word(each.request.clock_ns));
  if (each.request.profile != usual.request.profile) add("--profile", each.request.profile);
  if (!each.script.empty()) add("--script", each.script);
  for (const std::string& send : each.send) add("--send", send);
  if (!each.environment.empty()) add("--env", each.environment);
  for (const std::string& folder : each.libraries) add("--libraries", folder);
  if (each.sanitize) text += " --sanitize";
  if (each.untrusted) text += " --untrusted";
  return text;
}

/// Returns the inputs that all runs share, one per line.
std::string conditions_of(const wire::RunRequest& r, const std::string& version) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", version, r.start, r.goal, r.for_ns, r.clock_ns, r.profile,
                     r.script);
}

}  // namespace

class SweepSupplies {
 public:
  explicit SweepSupplies(launch::Listener listener) : launcher_(std::move(listener)) {}

  launch::Prepared prepare(const launch::Launch& launch, launch::Chosen chosen) {
    return launcher_.prepare(launch, std::move(chosen), describe_, describer().hello());
  }

  launch::PreparedFleet prepare(const launch::Fleet& fleet, launch::ChosenFleet chosen,
                                const wire::RunRequest& common) {
    return launch::prepare(launcher_, fleet, std::move(chosen), common, describe_, describer().hello());
  }

  /// Returns the target of a launch that requests a chip, but names no target.
  std::string chip_target(const launch::Launch& launch) { return launch::chip_target(launch, describe_); }

  const std::string& version() { return describer().hello().version; }

  const std::string& hash_of_file(const std::string& path) {
    const auto known = hashes_.find(path);
    if (known != hashes_.end()) return known->second;
    return hashes_.emplace(path, sha256_of_file(path)).first->second;
  }

  const std::string& hash_of_map(const std::string& path) {
    const auto known = hashes_.find(path);
    if (known != hashes_.end()) return known->second;
    return hashes_.emplace(path, map::sha256_of_map(path)).first->second;
  }

 private:
  const wire::RobotInfo& robot(const std::string& name) {
    const auto known = robots_.find(name);
    if (known != robots_.end()) return known->second;
    return robots_.emplace(name, describer().describe_robot(name)).first->second;
  }
  client::Runner& describer() {
    if (!describer_) describer_.emplace("host");  // a robot's description is the same for all targets
    return *describer_;
  }

  launch::Launcher launcher_;
  launch::Describe describe_ = [this](const std::string& name) { return robot(name); };
  std::optional<client::Runner> describer_;
  std::map<std::string, wire::RobotInfo> robots_;
  std::map<std::string, std::string> hashes_;
};

namespace {

/// Makes the combinations of one sweep.
class Combiner {
 public:
  Combiner(const SweepOptions& options, SweepSupplies& supplies)
      : options_(options), supplies_(supplies), each_(launch::launch_of(options.each)) {}

  void add_sketch(const std::string& name, std::vector<Combination>& combinations) {
    if (launch::is_fleet_file(name)) return add_fleet(name, combinations);
    std::vector<launch::Launch> launches;
    for (const std::string& map : or_default(options_.maps)) {
      for (const std::string& robot : or_default(options_.robots)) {
        for (const std::string& target : or_default(options_.targets)) {
          launch::Launch& launch = launches.emplace_back(each_);
          launch.sketch = name;
          launch.map = map;
          launch.robot = robot;
          launch.target = target;
          if (target.empty() && options_.each.chip_only) launch.target = supplies_.chip_target(launch);
        }
      }
    }
    std::vector<launch::Chosen> chosen;  // a wrong name is reported before anything is compiled
    for (const launch::Launch& launch : launches) chosen.push_back(choose(launch));
    for (std::size_t i = 0; i < launches.size(); ++i)
      combinations.push_back(combine(launches[i], std::move(chosen[i])));
  }

 private:
  /// Adds the combinations of a fleet file. A robot's settings in the file take precedence over the
  /// combination's.
  void add_fleet(const std::string& file, std::vector<Combination>& combinations) {
    if (options_.each.chip_only) throw InputError({file}, "--untrusted excludes several robots");
    for (const std::string& map : or_default(options_.maps)) {
      for (const std::string& robot : or_default(options_.robots)) {
        for (const std::string& target : or_default(options_.targets)) {
          launch::RunSettings all = options_.each;
          all.robot = robot;
          all.target = target;
          launch::Fleet fleet = launch::read_fleet(file);
          if (!map.empty()) fleet.map = map;
          launch::fill_up(fleet, all);
          combinations.push_back(combine(file, fleet, all));
        }
      }
    }
  }

  Combination combine(const std::string& file, launch::Fleet& fleet, const launch::RunSettings& all) {
    launch::ChosenFleet chosen = choose(fleet);
    wire::RunRequest common = all.request;
    common.script.clear();
    const std::string runner = chosen.runner;
    const launch::PreparedFleet run = supplies_.prepare(fleet, std::move(chosen), common);
    Combination c;
    c.task = {runner, run.request};
    c.inputs = launch::inputs_of(run.members.front(), supplies_.version());
    c.inputs.sketch = c.title = file;
    c.inputs.robot = fmt::format("{} robots", run.members.size());
    c.map_sha256 = supplies_.hash_of_map(run.request.map);
    std::string images, robots, targets, conditions = conditions_of(run.request, c.inputs.robosim);
    for (std::size_t i = 0; i < run.members.size(); ++i) {
      const launch::Prepared& member = run.members[i];
      images += supplies_.hash_of_file(member.request.image);
      robots += member.robot_info.sha256;
      if (targets.find(member.target) == targets.npos)
        targets += (targets.empty() ? "" : "+") + member.target;
      const wire::RunRequest& own = fleet.members[i].launch.request;
      conditions += fmt::format("\n{}\n{}\n{}\n{}\n{}\n{}", fleet.members[i].name, member.target, own.start,
                                own.goal, own.clock_ns, own.script);
    }
    c.inputs.target = targets;
    c.image_sha256 = supplies_.hash_of_file(run.request.image);
    c.robot_sha256 = run.members.front().robot_info.sha256;
    c.fingerprint.parts = {sha256(images).substr(0, kDigits), c.map_sha256.substr(0, kDigits),
                           sha256(robots).substr(0, kDigits), sha256(conditions).substr(0, kDigits)};
    c.replay = "robosim run " + shell_word(file) + " --map " + shell_word(run.members.front().map.name);
    if (!all.robot.empty()) c.replay += " --robot " + shell_word(all.robot);
    if (!all.target.empty()) c.replay += " --target " + all.target;
    c.replay += options_of(options_.each);
    return c;
  }

  static std::vector<std::string> or_default(const std::vector<std::string>& names) {
    return names.empty() ? std::vector<std::string>{""} : names;
  }

  Combination combine(const launch::Launch& launch, launch::Chosen chosen) {
    const launch::Prepared run = supplies_.prepare(launch, std::move(chosen));
    Combination c;
    c.task = {run.target, run.request};
    c.inputs = launch::inputs_of(run, supplies_.version());
    c.title = launch::title_of(run.sketch);
    c.image_sha256 = supplies_.hash_of_file(run.request.image);
    c.map_sha256 = supplies_.hash_of_map(run.request.map);
    c.robot_sha256 = run.robot_info.sha256;
    const std::string conditions = sha256(conditions_of(run.request, c.inputs.robosim));
    c.fingerprint.parts = {c.image_sha256.substr(0, kDigits), c.map_sha256.substr(0, kDigits),
                           c.robot_sha256.substr(0, kDigits), conditions.substr(0, kDigits)};
    c.replay = "robosim run " + shell_word(run.sketch.name);
    if (!launch.map.empty()) c.replay += " --map " + shell_word(launch.map);
    if (!launch.robot.empty()) c.replay += " --robot " + shell_word(launch.robot);
    if (run.target != "host" && run.sketch.elf_target.empty()) c.replay += " --target " + run.target;
    c.replay += options_of(options_.each);
    return c;
  }

  const SweepOptions& options_;
  SweepSupplies& supplies_;
  launch::Launch each_;
};

}  // namespace

std::string Fingerprint::text() const { return fmt::format("{}", fmt::join(parts, "-")); }

std::string Combination::text() const {
  return fmt::format("{} on {} with {}, target {}", title, inputs.map, inputs.robot, inputs.target);
}

client::Task SweepPlan::task_of(std::size_t run) const {
  client::Task task = combination_of(run).task;
  task.request.seed = seed_of(run);
  return task;
}

SweepPlanner::SweepPlanner(launch::Listener listener)
    : supplies_(std::make_unique<SweepSupplies>(std::move(listener))) {}

SweepPlanner::~SweepPlanner() = default;

SweepPlan SweepPlanner::plan(const SweepOptions& options) {
  SweepPlan plan;
  plan.first_seed = options.first_seed;
  plan.seeds = options.last_seed - options.first_seed + 1;
  Combiner combiner(options, *supplies_);
  if (options.sketches.empty()) combiner.add_sketch("", plan.combinations);
  for (const std::string& sketch : options.sketches) {
    std::vector<Combination> own;
    try {
      combiner.add_sketch(sketch, own);
    } catch (const build::CompileError& error) {
      if (plan.left_out.size() + 1 == options.sketches.size()) throw;
      plan.left_out.push_back(
          fmt::format("{} does not compile, and is left out: {}", sketch, error.first_line()));
    }
    std::move(own.begin(), own.end(), std::back_inserter(plan.combinations));
  }
  return plan;
}

std::string replay_command(const Combination& combination, std::uint64_t seed) {
  return fmt::format("{} --seed {}", combination.replay, seed);
}

}  // namespace robosim::campaign
