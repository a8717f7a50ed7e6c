#include "sim/cli/hunt/finding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/cli/launching.h"
#include "sim/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

std::string in_quotes(const std::string& text) { return fmt::format("\"{}\"", escaped(text)); }

std::string seconds(double s) { return fmt::format("{:g}s", std::ceil(s * 10.0) / 10.0); }

/// A path that is right from everywhere; names stay.
std::string from_everywhere(const std::string& name) {
  return launch::is_path(name) ? fs::absolute(name).lexically_normal().string() : name;
}

/// What of a run is not as usual, by the names of options and keys.
using Differences = std::vector<std::pair<std::string, std::string>>;
Differences differences_of(const HuntFinding& finding, const HuntBench& bench, const HuntArguments& arguments,
                           const fs::path& files) {
  const HuntWorld& world = finding.world;
  const HuntSpace& space = bench.space();
  const HuntSpace::Build& build = space.builds[world.build];
  Differences options;
  options.emplace_back(
      "map", world.drawn() ? (files / "world.map").string() : from_everywhere(space.maps[world.map].name));
  if (!robot_text(world, space).empty())
    options.emplace_back(
        "robot", (files / "robot.toml").string() + (bench.board().empty() ? "" : "@" + bench.board()));
  else if (!arguments.robot.empty())
    options.emplace_back("robot", from_everywhere(arguments.robot));
  if (build.target != "host") options.emplace_back("target", build.target);
  if (!arguments.each.request.start.empty()) options.emplace_back("start", arguments.each.request.start);
  if (!bench.script_of(world).empty()) options.emplace_back("script", (files / "script.txt").string());
  options.emplace_back("seed", std::to_string(world.seed));
  if (world.clock_ms != 0) options.emplace_back("clock", fmt::format("{}ms", world.clock_ms));
  if (arguments.each.request.profile != wire::RunRequest{}.profile)
    options.emplace_back("profile", arguments.each.request.profile);
  if (!arguments.each.environment.empty()) options.emplace_back("env", arguments.each.environment);
  if (!world.to_goal)
    options.emplace_back("goal", "none");
  else if (!space.maps[world.map].goal.empty() && !world.drawn())
    options.emplace_back("goal", space.maps[world.map].goal);
  options.emplace_back("for", seconds(world.for_s));
  return options;
}

std::string check_of(const HuntFinding& finding, std::size_t number, const HuntBench& bench,
                     const HuntArguments& arguments) {
  const Symptom& symptom = finding.symptom;
  std::string text = fmt::format("# {}\n[[check]]\nname = {}\n", symptom.sentence,
                                 in_quotes(fmt::format("hunt {}: {}", number, symptom.group)));
  for (const auto& [name, value] : differences_of(finding, bench, arguments, std::to_string(number)))
    text += fmt::format("{} = {}\n", name, name == "seed" ? value : in_quotes(value));
  for (const std::string& library : arguments.each.libraries)
    text += fmt::format("libraries = {}\n", in_quotes(fs::absolute(library).string()));
  if (bench.space().builds[finding.world.build].checked) text += "sanitize = true\n";
  if (symptom.kind == "collision") text += "collisions = { max = 0 }\n";
  return text;
}

std::string hunt_text(const HuntFinding& finding, std::size_t number, const HuntBench& bench) {
  const HuntSpace& space = bench.space();
  const HuntSpace::Build& build = space.builds[finding.world.build];
  std::string text = fmt::format("finding {}: {}\n", number, finding.symptom.sentence);
  text += fmt::format("  in      {}{}, {}{}{}\n", build.target, build.checked ? " with checks" : "",
                      finding.world.drawn() ? "a drawn map" : space.maps[finding.world.map].name,
                      finding.needs.empty() ? "; nothing else is needed" : "; it needs ",
                      fmt::format("{}", fmt::join(finding.needs, ", ")));
  return text + fmt::format("  replay  {}\n", finding.replay);
}

}  // namespace

bool HuntFinding::explains(const Symptom& other, const std::set<std::string>& needs_of_other) const {
  if (!symptom.is_behaviour || !other.is_behaviour) return symptom.group == other.group;
  if (needs.empty()) return true;
  return symptom.group == other.group &&
         std::includes(needs_of_other.begin(), needs_of_other.end(), needs.begin(), needs.end());
}

void keep(HuntFinding& finding, std::size_t number, const HuntBench& bench, const HuntArguments& arguments,
          const fs::path& out) {
  const fs::path folder = out / std::to_string(number);
  std::error_code none;
  fs::remove_all(folder, none);
  wire::RunRequest request = bench.request_of(finding.world, folder.string());
  if (!request.script.empty()) write_file(folder / "script.txt", request.script);
  const launch::Prepared& run = bench.of(finding.world);
  finding.replay = "robosim run " + shell_word(run.sketch.name);
  for (const auto& [name, value] : differences_of(finding, bench, arguments, folder))
    finding.replay += fmt::format(" --{} {}", name, shell_word(value));
  for (const std::string& library : arguments.each.libraries)
    finding.replay += " --libraries " + shell_word(library);
  if (bench.space().builds[finding.world.build].checked) finding.replay += " --sanitize";

  record::Recorders page({(folder / "run.html").string()});
  page.ask(request);
  client::Runner runner(run.target);
  page.begin({bench.version(), launch::title_of(run.sketch),
              finding.world.drawn() ? "world.map" : bench.space().maps[finding.world.map].name,
              run.robot.name, run.target, run.robot_info, request});
  page.finish(runner.run(request, [&](const wire::Event& event) { page.add(event); }));
  finding.text = hunt_text(finding, number, bench);
  finding.check = check_of(finding, number, bench, arguments);
}

}  // namespace robosim::cli
