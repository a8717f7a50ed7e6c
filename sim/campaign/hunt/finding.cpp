#include "sim/campaign/hunt/finding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/rerun/recorded.h"
#include "sim/launch/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

std::string in_quotes(const std::string& text) { return fmt::format("\"{}\"", escaped(text)); }

std::string seconds(double s) { return fmt::format("{:g}s", std::ceil(s * 10.0) / 10.0); }

/// Makes a path absolute; returns a name unchanged.
std::string from_everywhere(const std::string& name) {
  return launch::is_path(name) ? fs::absolute(name).lexically_normal().string() : name;
}

std::vector<Shown::Option> options_of(const HuntFinding& finding, const CampaignRunner& campaign,
                                      const HuntOptions& options) {
  const TestCase& test_case = finding.test_case;
  const HuntSpace& space = campaign.space();
  const HuntSpace::Build& build = space.builds[test_case.build];
  std::vector<Shown::Option> shown;
  const auto add = [&](const char* name, const std::string& value) { shown.push_back({name, value, false}); };
  const auto add_file = [&](const char* name, const std::string& value) {
    shown.push_back({name, value, true});
  };
  if (test_case.drawn())
    add_file("map", "world.map");
  else
    add("map", from_everywhere(space.maps[test_case.map].name));
  if (!robot_text(test_case, space).empty())
    add_file("robot", campaign.board().empty() ? "robot.toml" : "robot.toml@" + campaign.board());
  else if (!options.robot.empty())
    add("robot", from_everywhere(options.robot));
  if (test_case.differential == Differential::host)
    add("target", "host," + build.target);
  else if (build.target != "host")
    add("target", build.target);
  if (!options.each.request.start.empty()) add("start", options.each.request.start);
  if (!campaign.script_of(test_case).empty()) add_file("script", "script.txt");
  add("seed", std::to_string(test_case.seed));
  if (test_case.clock_ms != 0) add("clock", fmt::format("{}ms", test_case.clock_ms));
  if (options.each.request.profile != wire::RunRequest{}.profile)
    add("profile", options.each.request.profile);
  if (!options.each.environment.empty()) add("env", options.each.environment);
  if (!test_case.to_goal)
    add("goal", "none");
  else if (!space.maps[test_case.map].goal.empty() && !test_case.drawn())
    add("goal", space.maps[test_case.map].goal);
  add("for", seconds(test_case.for_s));
  for (const std::string& library : options.each.libraries)
    add("libraries", fs::absolute(library).lexically_normal().string());
  return shown;
}

std::string replay_of(const Shown& shown, const fs::path& folder) {
  std::string command =
      fmt::format("robosim {} {}", shown.compared ? "compare" : "run", shell_word(shown.sketch));
  for (const Shown::Option& option : shown.options)
    command += fmt::format(" --{} {}", option.name, shell_word(option.value_in(folder)));
  return command + (shown.checked || shown.detected ? " --sanitize" : "");
}

}  // namespace

std::string Shown::Option::value_in(const fs::path& folder) const {
  return own_file ? (folder / value).string() : value;
}

std::string hunt_check(const HuntFinding& finding, std::size_t number, const fs::path& out) {
  const Symptom& symptom = finding.symptom;
  const std::string folder = std::to_string(number);
  if (symptom.kind == kUnlike || symptom.kind == kWarned)  // no single run fails
    return fmt::format("# {}\n# {}\n", symptom.sentence, replay_of(finding.shown, folder));
  std::string text = fmt::format("# {}\n[[check]]\nname = {}\n", symptom.sentence,
                                 in_quotes(fmt::format("hunt {}: {}", number, symptom.group)));
  for (const Shown::Option& option : finding.shown.options) {
    std::string value = option.value_in(folder);
    // The project may move, so paths are relative to the file of checks.
    if (fs::path(value).is_absolute())
      value = fs::path(value).lexically_relative(fs::absolute(out).lexically_normal()).string();
    text += fmt::format("{} = {}\n", option.name, option.name == "seed" ? value : in_quotes(value));
  }
  if (finding.shown.checked) text += "sanitize = true\n";
  if (finding.shown.detected) text += "detect = true\n";
  if (symptom.kind == "collision") text += "collisions = { max = 0 }\n";
  return text;
}

std::string hunt_text(const HuntFinding& finding, std::size_t number, const fs::path& out) {
  std::string text = fmt::format("finding {}: {}\n", number, finding.symptom.sentence);
  text += fmt::format("  in      {}{}{}\n", finding.shown.where,
                      finding.needs.empty() ? "; no other conditions" : "; needs: ",
                      fmt::format("{}", fmt::join(finding.needs, ", ")));
  return text + fmt::format("  replay  {}\n", replay_of(finding.shown, out / std::to_string(number)));
}

bool HuntFinding::explains(const Symptom& other, const std::set<std::string>& needs_of_other) const {
  if (!symptom.is_behaviour || !other.is_behaviour) return symptom.group == other.group;
  if (needs.empty()) return true;
  return symptom.group == other.group &&
         std::includes(needs_of_other.begin(), needs_of_other.end(), needs.begin(), needs.end());
}

void keep(HuntFinding& finding, std::size_t number, const CampaignRunner& campaign,
          const HuntOptions& options, const fs::path& out) {
  const fs::path folder = out / std::to_string(number);
  std::error_code none;
  fs::remove_all(folder, none);
  wire::RunRequest request = campaign.request_of(finding.test_case, folder.string());
  if (!request.script.empty()) write_file(folder / "script.txt", request.script);
  const launch::Prepared& run = campaign.of(finding.test_case);
  const HuntSpace::Build& build = campaign.space().builds[finding.test_case.build];
  finding.shown = {fmt::format("{}{}, {}", build.target, build.checked ? " with checks" : "",
                               finding.test_case.drawn() ? "a drawn map"
                                                         : campaign.space().maps[finding.test_case.map].name),
                   run.sketch.name,
                   options_of(finding, campaign, options),
                   build.checked,
                   finding.symptom.kind == kDetected,
                   finding.test_case.differential == Differential::host};

  record::Recorders page({(folder / "run.html").string()});
  page.ask(request);
  client::Runner runner(run.target);
  page.begin({campaign.version(), launch::title_of(run.sketch),
              finding.test_case.drawn() ? "world.map" : campaign.space().maps[finding.test_case.map].name,
              run.robot.name, run.target, run.robot_info, request});
  page.finish(runner.run(request, [&](const wire::Event& event) { page.add(event); }));
}

}  // namespace robosim::campaign
