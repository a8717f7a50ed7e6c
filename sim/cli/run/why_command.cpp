#include "sim/cli/run/why_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "sim/base/terminal_text.h"
#include "sim/campaign/rerun/sanitizer_rerun.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/cli/run/source_text.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/run_json.h"

namespace robosim::cli {

namespace {

constexpr std::size_t kMostLines = 10, kMostFindings = 3;

/// Returns whether the lines of a cause ran at its time. Returns false if they ran long before, or never.
bool is_live(const result::Cause& cause) { return cause.t_s > 0.0 && cause.text != result::kSetBefore; }

/// Keeps the most direct lines of a chain: the first line of each cause, then the other lines of live causes,
/// then the rest. Returns the number of removed lines.
std::size_t keep_direct(std::vector<result::Cause>& chain) {
  std::size_t all = 0, room = kMostLines;
  for (const result::Cause& cause : chain) all += cause.lines.size();
  if (all <= kMostLines) return 0;
  std::vector<std::size_t> kept(chain.size());
  const auto take_turns = [&](std::size_t turns, bool (*may)(const result::Cause&)) {
    for (std::size_t turn = 0; turn < turns; ++turn)
      for (std::size_t i = 0; i < chain.size() && room > 0; ++i)
        if (kept[i] < chain[i].lines.size() && may(chain[i])) ++kept[i], --room;
  };
  take_turns(1, [](const result::Cause&) { return true; });
  take_turns(kMostLines, is_live);
  take_turns(kMostLines, [](const result::Cause&) { return true; });
  for (std::size_t i = 0; i < chain.size(); ++i) chain[i].lines.resize(kept[i]);
  return all - kMostLines;
}

/// Moves the sketch's own lines of each cause before those of libraries.
void put_own_first(std::vector<result::Cause>& chain, const std::string& folder) {
  const auto is_own = [&](const result::SourceLine& line) {
    std::error_code none;
    return std::filesystem::exists(std::filesystem::path(folder) / line.file, none);
  };
  for (result::Cause& cause : chain) std::stable_partition(cause.lines.begin(), cause.lines.end(), is_own);
}

std::string chain_text(result::RunResult result, SourceText& source, const std::vector<std::string>& unset,
                       bool shows_all) {
  std::string text = fmt::format("{}: {}\n", result.verdict, in_one_line(result.why));
  for (std::size_t i = 0; i < std::min(unset.size(), kMostFindings); ++i)
    text += fmt::format("\n{}\n", unset[i]);
  for (std::size_t i = 0; i < std::min(result.detected.size(), kMostFindings); ++i)
    text += fmt::format("\ndetected: {}\n", result::text_of(result.detected[i]));
  if (result.because.empty()) return text;
  const std::size_t removed = shows_all ? 0 : keep_direct(result.because);
  text += '\n';
  const char* arrow = "";
  for (const result::Cause& cause : result.because) {
    const std::string when = cause.t_s > 0.0 ? fmt::format("{:.3f} s", cause.t_s) : "";
    text += fmt::format("{:>10}  {}{}\n", when, arrow, in_one_line(cause.text));
    for (const result::SourceLine& line : cause.lines)
      text += fmt::format("{:>16}{:<26}  {}\n", "", fmt::format("{}:{}", in_one_line(line.file), line.line),
                          source.line(line));
    arrow = "← ";
  }
  if (removed > 0) text += fmt::format("\n{} more lines: --all\n", removed);
  return text;
}

}  // namespace

int why_command(const WhyArguments& arguments) {
  launch::Launch launch = launch::launch_of(arguments.run);
  launch::Chosen chosen = choose(launch);
  launch.request.why = launch.request.detect = true;
  client::Runner runner(chosen.target);
  terminal::Progress progress(!arguments.run.json);
  launch::Launcher launcher(listener_of(progress));
  const launch::Prepared run = launcher.prepare(
      launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
      runner.hello());
  progress.say("running " + launch::title_of(run.sketch) + ", then tracing its verdict back …");
  const client::Interrupts interrupts(runner);
  result::RunResult result = runner.run(run.request);
  progress.clear();
  SourceText source(run.sketch.folder, {run.wanted.libraries.begin(), run.wanted.libraries.end()},
                    !arguments.run.untrusted);
  source.explain(result.because);
  put_own_first(result.because, run.sketch.folder);
  if (arguments.run.json)
    print(
        launch::run_json(launch::inputs_of(run, runner.hello().version), result, std::nullopt, std::nullopt));
  else
    print(chain_text(result, source, campaign::unset_variables(run.wanted, result), arguments.all));
  return result.status;
}

}  // namespace robosim::cli
