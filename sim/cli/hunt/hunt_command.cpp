#include "sim/cli/hunt/hunt_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/cli/hunt/hunt.h"
#include "sim/cli/output.h"
#include "sim/client/interrupts.h"

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
      throw InputError({folder.string()}, "holds no hunt that --resume could go on with");
    return folder;
  }
  if (fs::exists(folder, error))
    throw InputError({folder.string()},
                     "is there already; --resume goes on with it, --out DIR names another, or remove it");
  if (!fs::create_directories(folder, error))
    throw InputError({folder.string()}, "cannot be made a folder: " + error.message());
  return folder;
}

/// With what must never and always be, which the checks keep, too.
std::string checks_text(const Hunt& hunt, const HuntBench& bench) {
  std::string text;
  for (const auto& [key, when] :
       {std::pair{"never", Promise::When::never}, {"always", Promise::When::always}}) {
    std::string list;
    for (const Promise& promise : bench.space().promises)
      if (promise.when == when)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", escaped(promise.text()));
    if (!list.empty()) text += fmt::format("{} = [{}]\n", key, list);
  }
  for (const HuntFinding& finding : hunt.findings()) text += (text.empty() ? "" : "\n") + finding.check;
  return text;
}

std::string opening_text(const HuntBench& bench) {
  std::string text;
  for (const Deed& deed : bench.space().opening)
    text += fmt::format(", {} at {} s", deed.kind, deed.at_ms / 1000);
  return text;
}

std::string hunt_summary(const Hunt& hunt, const HuntBench& bench, const fs::path& out) {
  const std::size_t found = hunt.findings().size();
  std::string text = fmt::format("{} runs, {:.0f} s of simulated time: {}\n", hunt.runs(), hunt.simulated_s(),
                                 found == 0   ? std::string("nothing was found")
                                 : found == 1 ? std::string("1 finding")
                                              : fmt::format("{} findings", found));
  for (std::size_t i = 0; i < found; ++i)
    text += fmt::format("  {:3}  {} run{}  {}\n", i + 1, hunt.findings()[i].times,
                        hunt.findings()[i].times == 1 ? "" : "s", hunt.findings()[i].symptom.group);
  if (bench.refused() > 0)
    text += fmt::format("{} worlds could not be run; the first: {}\n", bench.refused(), bench.refusal());
  if (found > 0)
    text += fmt::format("checks that fail until it is mended: {}\n", (out / "checks.toml").string());
  return text;
}

}  // namespace

int hunt_command(const HuntArguments& arguments) {
  tui::Progress progress(true);
  HuntBench bench(arguments, progress);
  const client::Interrupts interrupts(bench.pool());
  const fs::path out = folder_for(arguments);
  for (const std::string& sentence : bench.left_out())
    complain(fmt::format("robosim: left out: {}\n", sentence));
  HuntLog log(out, bench.fingerprint(), arguments.resume);
  Hunt hunt(bench, arguments, out, log,
            {[&](const std::string& sentence) { progress.update(sentence); },
             [&](const HuntFinding& finding, std::size_t) {
               progress.clear();
               print(finding.text + "\n");
               write_file(out / "checks.toml", checks_text(hunt, bench));
             }});
  const bool complete = hunt.go();
  progress.clear();
  print(fmt::format("{} on {}{}, {}\n", launch::title_of(bench.of(hunt.plain_world()).sketch),
                    bench.space().maps.front().name, opening_text(bench),
                    bench.of(hunt.plain_world()).robot.name) +
        hunt_summary(hunt, bench, out));
  if (!complete) complain("robosim: interrupted; the same command with --resume goes on\n");
  if (!complete) return static_cast<int>(ExitStatus::interrupted);
  return static_cast<int>(hunt.findings().empty() ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
