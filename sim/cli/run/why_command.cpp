#include "sim/cli/run/why_command.h"

#include <fmt/format.h>

#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/cli/run/source_text.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/run_json.h"

namespace robosim::cli {

namespace {

std::string chain_text(const result::RunResult& result, SourceText& source) {
  std::string text = fmt::format("{}: {}\n", result.verdict, result.why);
  if (result.because.empty()) return text;
  text += '\n';
  const char* arrow = "";
  for (const result::Cause& cause : result.because) {
    const std::string when = cause.t_s > 0.0 ? fmt::format("{:.3f} s", cause.t_s) : "";
    text += fmt::format("{:>10}  {}{}\n", when, arrow, cause.text);
    for (const result::SourceLine& line : cause.lines)
      text += fmt::format("{:>16}{:<26}  {}\n", "", fmt::format("{}:{}", line.file, line.line),
                          source.line(line));
    arrow = "← ";
  }
  return text;
}

}  // namespace

int why_command(const WhyArguments& arguments) {
  launch::Launch launch = launch::launch_of(arguments.run);
  launch::Chosen chosen = choose(launch);
  launch.request.why = true;
  client::Runner runner(chosen.target);
  terminal::Progress progress(!arguments.run.json);
  launch::Launcher launcher(listener_of(progress));
  const launch::Prepared run = launcher.prepare(
      launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
      runner.hello());
  progress.say("running " + launch::title_of(run.sketch) + ", and back from its verdict …");
  const client::Interrupts interrupts(runner);
  result::RunResult result = runner.run(run.request);
  progress.clear();
  // Also searches two folders above the sketch: the sketch may be an example of a library that it uses.
  std::vector<std::filesystem::path> folders = {run.sketch.folder, run.sketch.folder / "../.."};
  folders.insert(folders.end(), run.wanted.libraries.begin(), run.wanted.libraries.end());
  SourceText source(std::move(folders));
  source.explain(result.because);
  if (arguments.run.json)
    print(
        launch::run_json(launch::inputs_of(run, runner.hello().version), result, std::nullopt, std::nullopt));
  else
    print(chain_text(result, source));
  return result.status;
}

}  // namespace robosim::cli
