#include "sim/cli/launching.h"

#include <fmt/format.h>

#include "sim/base/file.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace {

constexpr std::size_t kMostScript_bytes = std::size_t{16} << 20;

}  // namespace

std::string script_text(const std::string& file) { return read_file(file, kMostScript_bytes); }

std::string scenario_text(const RunArguments& arguments) {
  std::string text;
  if (!arguments.script.empty()) text = script_text(arguments.script);
  if (!text.empty() && text.back() != '\n') text += '\n';
  for (const std::string& send : arguments.send) text += fmt::format("at 1s send \"{}\"\n", send);
  return text;
}

launch::Launch launch_of(const RunArguments& arguments) {
  launch::Launch launch = arguments;
  launch.request.script = scenario_text(arguments);
  launch.request.script_file = arguments.script.empty() ? "--send" : arguments.script;
  return launch;
}

launch::Listener listener_of(terminal::Progress& progress, Says says) {
  launch::Listener listener;
  if (says.choices)
    listener.chosen = [](const std::string& sentence) { complain(fmt::format("robosim: {}\n", sentence)); };
  listener.lacking = [](const std::string& sentence) { complain(fmt::format("robosim: {}\n", sentence)); };
  listener.compiling = [&progress](const std::string& sketch) { progress.say("compiling " + sketch + " …"); };
  listener.compiling_core = [&progress](const std::string& board, const std::string& target) {
    progress.say(
        fmt::format("compiling the Arduino core of the {} for {}, once for all sketches …", board, target));
  };
  listener.compiled = [&progress, says](const build::Image& image) {
    progress.clear();
    if (says.warnings && !image.messages.empty()) complain(image.messages);
  };
  return listener;
}

record::RecordedRun recorded(const launch::Prepared& run, const std::string& version) {
  return {version,    launch::title_of(run.sketch), run.map.name, run.robot.name, run.target, run.robot_info,
          run.request};
}

record::RecordedRun recorded(const launch::Fleet& fleet, const launch::PreparedFleet& run,
                             const std::string& version) {
  record::RecordedRun all = recorded(run.members.front(), version);
  all.request = run.request;
  for (std::size_t i = 0; i < run.members.size(); ++i) {
    const launch::Prepared& one = run.members[i];
    all.robots.push_back(
        {fleet.members[i].name, launch::title_of(one.sketch), one.robot.name, one.target, one.robot_info});
  }
  return all;
}

}  // namespace robosim::cli
