#include "sim/testing/artifacts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "sim/base/error.h"
#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/profile.h"
#include "sim/base/shell_word.h"
#include "sim/record/recorder.h"
#include "sim/testing/silent_run.h"

namespace robosim::testing {
namespace fs = std::filesystem;

namespace {

constexpr const char* kFleetFile = "robots.toml";

std::string as_word(const std::string& text) {
  std::string word;
  for (const char c : text) word += c == '/' ? '.' : c;
  return word;
}

std::string of_another_run(const std::string& folder) {
  return "the run recorded in " + folder + " differs from the test's run: this is a fault of Robosim";
}

}  // namespace

std::string artifact_folder() {
  if (is_silent_run()) return "";
  const char* chosen = std::getenv("ROBOSIM_ARTIFACTS");
  if (chosen && std::string(chosen) == "none") return "";
  const fs::path base = chosen && *chosen ? chosen : "robosim-artifacts";
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name =
      test ? as_word(fmt::format("{}.{}", test->test_suite_name(), test->name())) : "outside-a-test";
  static std::map<std::string, int> runs;
  const int number = ++runs[name];
  return (base / (number == 1 ? name : fmt::format("{}-{}", name, number))).string();
}

std::string replay_command(const ResolvedTrial& resolved_trial, const std::string& folder, bool script) {
  const wire::RunRequest& r = resolved_trial.request;
  const fs::path kept = folder;
  std::string text = "robosim run " + shell_word(resolved_trial.sketch);
  text +=
      " --map " + shell_word(resolved_trial.map_is_text ? (kept / "map.map").string() : resolved_trial.map);
  text += " --robot " + shell_word(resolved_trial.robot_is_text ? (kept / "robot.toml").string()
                                                                : resolved_trial.robot_name);
  text += " --target " + resolved_trial.target;
  text += fmt::format(" --seed {}", r.seed);
  if (profile_of(r.profile) != Profile::typical) text += " --profile " + r.profile;
  if (!r.start.empty()) text += " --start " + shell_word(r.start);
  if (!r.goal.empty()) text += " --goal " + shell_word(r.goal);
  if (r.clock_ns > 0) text += fmt::format(" --clock {}ns", r.clock_ns);
  for (const std::string& folder_of_libraries : resolved_trial.libraries)
    text += " --libraries " + shell_word(folder_of_libraries);
  if (script) text += " --script " + shell_word((kept / "script.txt").string());
  return text;
}

void keep_inputs(const std::string& name, const ResolvedTrial& resolved_trial, const std::string& script) {
  if (name.empty()) return;
  const fs::path folder = name;
  fs::create_directories(folder);
  write_file(folder / "map.map", read_file(resolved_trial.request.map));
  write_file(folder / "robot.toml", read_file(resolved_trial.robot.file));
  if (!script.empty()) write_file(folder / "script.txt", script);
}

void keep_texts(const RunLog& log, const std::string& folder, const std::string& prefix) {
  write_file(fs::path(folder) / (prefix + "serial.txt"), log.serial);
  std::string events;
  for (const RunLog::Entry& entry : log.events)
    events += fmt::format("{:>10}  {}\n", seconds(entry.t_ns), entry.text);
  write_file(fs::path(folder) / (prefix + "events.txt"), events);
}

std::string replay_command(const FleetTrial& trial, const std::string& folder) {
  std::string text = "robosim run " + shell_word((fs::path(folder) / kFleetFile).string());
  text += fmt::format(" --seed {}", trial.seed);
  if (profile_of(trial.profile) != Profile::typical) text += " --profile " + trial.profile;
  return text;
}

void keep_inputs(const std::string& name, const launch::Fleet& fleet,
                 const std::vector<ResolvedTrial>& resolved_trials, const std::vector<std::string>& scripts) {
  const fs::path folder = name;
  fs::create_directories(folder);
  write_file(folder / "map.map", read_file(resolved_trials.front().request.map));
  std::string text = "map = \"./map.map\"\n";
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{} = \"{}\"\n", key, escaped(value));
  };
  const auto resolved = [](const std::string& word, bool is_path) {
    return is_path ? fs::absolute(word).lexically_normal().string() : word;
  };
  for (std::size_t i = 0; i < resolved_trials.size(); ++i) {
    const launch::Member& member = fleet.members[i];
    text += "\n[[agent]]\n";
    add("name", member.name);
    add("sketch", resolved(resolved_trials[i].sketch, build::is_sketch_path(resolved_trials[i].sketch)));
    if (resolved_trials[i].robot_is_text) {
      write_file(folder / (member.name + ".toml"), read_file(resolved_trials[i].robot.file));
      add("robot", "./" + member.name + ".toml");
    } else {
      add("robot", resolved(resolved_trials[i].robot_name, launch::is_path(resolved_trials[i].robot_name)));
    }
    add("target", resolved_trials[i].target);
    add("start", member.launch.request.start);
    add("goal", member.launch.request.goal);
    if (member.launch.request.clock_ns > 0) add("clock", fmt::format("{}ns", member.launch.request.clock_ns));
    if (!scripts[i].empty()) {
      write_file(folder / (member.name + ".txt"), scripts[i]);
      add("script", "./" + member.name + ".txt");
    }
    std::string folders;
    for (const std::string& library : resolved_trials[i].libraries)
      folders += fmt::format("{}\"{}\"", folders.empty() ? "" : ", ",
                             escaped(resolved(library, launch::is_path(library))));
    if (!folders.empty()) text += fmt::format("libraries = [{}]\n", folders);
  }
  write_file(folder / kFleetFile, text);
}

std::string record_again(const launch::Fleet& fleet, const std::vector<ResolvedTrial>& resolved_trials,
                         const std::vector<std::string>& scripts, const result::RunResult* expected,
                         std::int64_t until_ns, const std::string& name, client::Runner& runner) {
  const fs::path folder = name;
  const ResolvedTrial& first = resolved_trials.front();
  wire::RunRequest request = first.request;
  request.script = scripts.front();
  for (std::size_t i = 1; i < scripts.size(); ++i) request.agents[i - 1].script = scripts[i];
  request.for_ns = until_ns;
  record::Recorders recorders({folder / "run.csv", folder / "run.vcd", folder / kPage});
  recorders.ask(request);
  const std::string map_name = first.map_is_text ? "the test's map" : fs::path(first.map).stem().string();
  record::RecordedRun recorded{runner.hello().version, first.sketch_title, map_name, first.robot.name,
                               first.target,           first.robot,        request};
  for (std::size_t i = 0; i < resolved_trials.size(); ++i)
    recorded.robots.push_back({fleet.members[i].name, resolved_trials[i].sketch_title,
                               resolved_trials[i].robot.name, resolved_trials[i].target,
                               resolved_trials[i].robot});
  recorders.begin(recorded);
  const result::RunResult again =
      runner.run(request, [&](const wire::Event& event) { recorders.add(event); });
  recorders.finish(again);
  if (!expected || again.trace_hash == expected->trace_hash) return "";
  return of_another_run(name);
}

std::string keep(const RunLog& log, const ResolvedTrial& resolved_trial, const std::string& script,
                 client::Runner& runner) {
  try {
    const fs::path folder = log.artifacts;
    keep_inputs(log.artifacts, resolved_trial, script);
    keep_texts(log, folder, "");
    const std::int64_t until_ns = log.legs.empty() ? 0 : log.legs.back().end_ns;
    write_file(folder / "command.txt", fmt::format("{} --for {}ms\n", log.replay, until_ns / 1'000'000));
    if (until_ns == 0) return "";
    wire::RunRequest request = resolved_trial.request;
    request.script = script;
    request.for_ns = until_ns;
    request.counters.clear();
    record::Recorders recorders({folder / "run.csv", folder / "run.vcd", folder / kPage});
    recorders.ask(request);
    recorders.begin({runner.hello().version, log.sketch_name, log.map_name, log.robot_name, log.trial.target,
                     resolved_trial.robot, request});
    const result::RunResult again =
        runner.run(request, [&](const wire::Event& event) { recorders.add(event); });
    recorders.finish(again);
    if (!log.result || again.trace_hash == log.result->trace_hash) return "";
    return of_another_run(folder.string());
  } catch (const std::exception& problem) {
    return fmt::format("the files saved in {} are incomplete: {}", log.artifacts, problem.what());
  }
}

}  // namespace robosim::testing
