#include "sim/cli/hunt/hunt_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/hunt/hunt.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/launch/client/interrupts.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

fs::path folder_for(const HuntArguments& arguments) {
  fs::path folder = arguments.out;
  if (folder.empty()) {
    const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch, arguments.each.environment);
    folder = "hunt-" + fs::path(launch::title_of(sketch)).lexically_normal().filename().stem().string();
  }
  std::error_code error;
  if (arguments.resume) {
    if (!fs::exists(folder / "runs.jsonl", error))
      throw InputError({folder.string()}, "expected the folder of a hunt for --resume, got another folder");
    return folder;
  }
  if (fs::exists(folder, error))
    throw InputError({folder.string()},
                     "exists already; --resume continues it, --out DIR names another, or remove it");
  if (!fs::create_directories(folder, error))
    throw InputError({folder.string()}, "the folder cannot be created: " + error.message());
  return folder;
}

/// Returns the text of a checks.toml that fails until the findings are fixed. Repeats the hunt's `never` and
/// `always` assertions, because findings may depend on them.
std::string checks_text(const std::vector<campaign::HuntFinding>& findings,
                        const campaign::CampaignRunner& runner, const fs::path& out) {
  std::string text;
  for (const auto& [key, when] : {std::pair{"never", campaign::TextAssertion::When::never},
                                  {"always", campaign::TextAssertion::When::always}}) {
    std::string list;
    for (const campaign::TextAssertion& assertion : runner.space().assertions)
      if (assertion.when == when)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", escaped(assertion.text()));
    if (!list.empty()) text += fmt::format("{} = [{}]\n", key, list);
  }
  for (std::size_t i = 0; i < findings.size(); ++i)
    text += (text.empty() ? "" : "\n") + campaign::hunt_check(findings[i], i + 1, out);
  return text;
}

std::string opening_text(const campaign::CampaignRunner& runner) {
  std::string text;
  for (const campaign::Stimulus& stimulus : runner.space().opening)
    text += fmt::format(", {} at {} s", stimulus.kind, stimulus.at_ms / 1000);
  return text;
}

std::string hunt_summary(const campaign::Hunt& hunt, const campaign::CampaignRunner& runner,
                         const fs::path& out) {
  const std::size_t found = hunt.findings().size();
  std::string text = fmt::format("{} runs, {:.0f} s of simulated time: {}\n", hunt.runs(), hunt.simulated_s(),
                                 found == 0   ? std::string("nothing was found")
                                 : found == 1 ? std::string("1 finding")
                                              : fmt::format("{} findings", found));
  for (std::size_t i = 0; i < found; ++i)
    text += fmt::format("  {:3}  {} run{}  {}\n", i + 1, hunt.findings()[i].times,
                        hunt.findings()[i].times == 1 ? "" : "s", hunt.findings()[i].symptom.group);
  text += hunt.remark();
  if (hunt.runs_with_goal() > 0) {
    std::string others;
    for (const auto& [verdict, runs] : hunt.runs_that_missed())
      others += fmt::format("{}{} {}", others.empty() ? "; the others: " : ", ", runs, verdict);
    text += fmt::format("{} of {} runs reached the goal {}{}\n", hunt.runs_that_reached(),
                        hunt.runs_with_goal(), hunt.baseline().result.goal, others);
  }
  for (const std::string& map : hunt.baseline().reached() ? runner.left_maps() : std::vector<std::string>{})
    text += fmt::format(
        "{0} was skipped, because the sketch did not reach its goal there: --map {0} includes it\n", map);
  for (const campaign::HuntSpace::Map& map : runner.space().maps)
    if (!map.tours)
      text += fmt::format(
          "the sketch reaches its goal on the map {0}, but not on most similar floors: findings about its "
          "driving on such floors are reported only with --map {0}\n",
          map.name);
  if (runner.refused() > 0)
    text += fmt::format("{} world{} could not be run; the first: {}\n", runner.refused(),
                        runner.refused() == 1 ? "" : "s", runner.refusal());
  if (found > 0)
    text +=
        fmt::format("checks that fail until the findings are fixed: {}\n", (out / "checks.toml").string());
  return text;
}

std::string part_of(const HuntArguments& arguments) {
  if (!arguments.merge.empty()) return campaign::kMerged;
  return arguments.shard.whole() ? "" : arguments.shard.text();
}

/// Returns a message for each shard whose results are missing in `parts`.
std::vector<std::string> missing_of(const std::vector<campaign::HuntPart>& parts) {
  std::vector<std::string> sentences;
  for (std::uint64_t i = 0; !parts.empty() && i < parts.front().shard.count; ++i) {
    const bool given = std::any_of(parts.begin(), parts.end(),
                                   [&](const campaign::HuntPart& part) { return part.shard.index == i; });
    if (!given)
      sentences.push_back(fmt::format("robosim: shard {} is missing: its runs are not counted here\n",
                                      campaign::Shard{i, parts.front().shard.count}.text()));
  }
  return sentences;
}

}  // namespace

int hunt_command(const HuntArguments& arguments) {
  terminal::Progress progress(true);
  campaign::CampaignRunner runner(arguments, listener_of(progress, {false, false}));
  const client::Interrupts interrupts(runner.pool());
  const std::vector<campaign::HuntPart> parts = campaign::read_parts(arguments.merge, runner.fingerprint());
  const fs::path out = folder_for(arguments);
  for (const std::string& sentence : runner.left_out())
    complain(fmt::format("robosim: skipped: {}\n", sentence));
  campaign::HuntLog log(out, runner.fingerprint(), part_of(arguments), arguments.resume);
  campaign::Hunt hunt(
      runner, arguments, out, log,
      {[&](const std::string& sentence) { progress.update(sentence); },
       [&](const campaign::Symptom& symptom, std::uint64_t run) {
         progress.clear();
         complain(fmt::format("robosim: run {}: {} Looking for the smallest world that shows it\n", run + 1,
                              symptom.sentence));
       },
       [&](const campaign::HuntFinding& finding, std::size_t number) {
         progress.clear();
         print(campaign::hunt_text(finding, number, out) + "\n");
         write_file(out / "checks.toml", checks_text(hunt.findings(), runner, out));
       }});
  const bool complete = parts.empty() ? hunt.go() : hunt.merge(parts);
  progress.clear();
  print(fmt::format("{} on {}{}, {}\n", launch::title_of(runner.of(hunt.plain_world()).sketch),
                    runner.space().maps.front().name, opening_text(runner),
                    runner.of(hunt.plain_world()).robot.name) +
        hunt_summary(hunt, runner, out));
  for (const std::string& sentence : missing_of(parts)) complain(sentence);
  if (!complete)
    complain(parts.empty() ? "robosim: interrupted; the same command with --resume continues\n"
                           : "robosim: interrupted\n");
  if (!complete) return static_cast<int>(ExitStatus::interrupted);
  return static_cast<int>(hunt.findings().empty() ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
