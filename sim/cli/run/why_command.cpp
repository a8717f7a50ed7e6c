#include "sim/cli/run/why_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

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

constexpr std::size_t kMostRows = 10, kMostFindings = 3;

/// A printed row of a cause: a line of the source, or several lines of one file with declarations.
struct Row {
  std::string place, text;
  bool is_own = false;  ///< of the sketch's folder, not of a library
};

struct Link {
  const result::Cause* cause;
  std::vector<Row> rows;     ///< the sketch's own rows first
  std::size_t kept = kMany;  ///< number of printed rows
  static constexpr std::size_t kMany = ~std::size_t{0};
};

bool is_in(const std::string& folder, const result::SourceLine& line) {
  std::error_code none;
  return std::filesystem::exists(std::filesystem::path(folder) / line.file, none);
}

/// Joins the declarations of each file in one row, such as "Robot.ino:3,4" and "LEFT 5 · RIGHT 6".
std::vector<Row> rows_of_names(std::vector<result::SourceLine> lines, SourceText& source,
                               const std::string& folder) {
  std::sort(lines.begin(), lines.end(), [](const result::SourceLine& a, const result::SourceLine& b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  std::vector<Row> rows;
  std::string file;
  for (const result::SourceLine& line : lines) {
    if (rows.empty() || line.file != file)
      rows.push_back({in_one_line(line.file) + ":", "", is_in(folder, line)});
    else
      rows.back().place += ",", rows.back().text += " · ";
    file = line.file;
    rows.back().place += std::to_string(line.line);
    rows.back().text += source.declaration(line);
  }
  return rows;
}

std::vector<Link> links_of(const std::vector<result::Cause>& chain, SourceText& source,
                           const std::string& folder) {
  std::vector<Link> links;
  for (const result::Cause& cause : chain) {
    Link link{&cause, {}};
    if (cause.text == kNamed) link.rows = rows_of_names(cause.lines, source, folder);
    if (cause.text != kNamed)
      for (const result::SourceLine& line : cause.lines)
        link.rows.push_back({fmt::format("{}:{}", in_one_line(line.file), line.line), source.line(line),
                             is_in(folder, line)});
    std::stable_partition(link.rows.begin(), link.rows.end(), [](const Row& row) { return row.is_own; });
    links.push_back(std::move(link));
  }
  return links;
}

/// Keeps the most direct rows of a chain: one row of each link, and a second one of values set long before.
/// More rows of the links that ran at their time follow, then the rest. Rows of the sketch come before those
/// of libraries. Returns the number of removed rows.
std::size_t keep_direct(std::vector<Link>& links) {
  std::size_t all = 0, room = kMostRows;
  for (const Link& link : links) all += link.rows.size();
  if (all <= kMostRows) return 0;
  for (Link& link : links) link.kept = 0;
  const auto take_turns = [&](std::size_t turns, auto may) {
    for (std::size_t turn = 0; turn < turns; ++turn)
      for (Link& link : links)
        if (room > 0 && link.kept < link.rows.size() && may(link, link.rows[link.kept])) ++link.kept, --room;
  };
  const auto was_set_before = [](const Link& link) { return link.cause->text == result::kSetBefore; };
  const auto is_own = [](const Link&, const Row& row) { return row.is_own; };
  take_turns(1, is_own);
  take_turns(1, [&](const Link& link, const Row& row) { return row.is_own && was_set_before(link); });
  take_turns(kMostRows, [&](const Link& link, const Row& row) {
    return row.is_own && link.cause->t_s > 0.0 && !was_set_before(link);
  });
  take_turns(kMostRows, is_own);
  take_turns(kMostRows, [](const Link&, const Row&) { return true; });
  return all - kMostRows;
}

std::string chain_text(const result::RunResult& result, SourceText& source, const std::string& folder,
                       const std::vector<std::string>& unset, bool shows_all) {
  std::string text = fmt::format("{}: {}\n", result.verdict, in_one_line(result.why));
  for (std::size_t i = 0; i < std::min(unset.size(), kMostFindings); ++i)
    text += fmt::format("\n{}\n", unset[i]);
  for (std::size_t i = 0; i < std::min(result.detected.size(), kMostFindings); ++i)
    text += fmt::format("\ndetected: {}\n", result::text_of(result.detected[i]));
  if (result.because.empty()) return text;
  std::vector<Link> links = links_of(result.because, source, folder);
  const std::size_t removed = shows_all ? 0 : keep_direct(links);
  text += '\n';
  const char* arrow = "";
  for (const Link& link : links) {
    if (link.kept == 0 && !link.rows.empty()) continue;
    const std::string when = link.cause->t_s > 0.0 ? fmt::format("{:.3f} s", link.cause->t_s) : "";
    text += fmt::format("{:>10}  {}{}\n", when, arrow, in_one_line(link.cause->text));
    for (std::size_t i = 0; i < std::min(link.kept, link.rows.size()); ++i)
      text += fmt::format("{:>16}{:<26}  {}\n", "", link.rows[i].place, link.rows[i].text);
    arrow = "← ";
  }
  if (removed > 0) text += fmt::format("\n{} more line{}: --all\n", removed, removed == 1 ? "" : "s");
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
  if (arguments.run.json)
    print(
        launch::run_json(launch::inputs_of(run, runner.hello().version), result, std::nullopt, std::nullopt));
  else
    print(chain_text(result, source, run.sketch.folder, campaign::unset_variables(run.wanted, result),
                     arguments.all));
  return result.status;
}

}  // namespace robosim::cli
