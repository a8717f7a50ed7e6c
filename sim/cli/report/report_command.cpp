#include "sim/cli/report/report_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/write_claim.h"
#include "sim/cli/output.h"
#include "sim/cli/report/made_again.h"
#include "sim/cli/report/report_page.h"
#include "sim/record/record_page.h"

namespace robosim::cli {
namespace {

namespace fs = std::filesystem;

/// Letters, digits and - of a run's names.
std::string name_of(const SweptRun& run) {
  std::string name;
  for (const char c : fmt::format("{} {} {} {} {}", run.sketch, run.map, run.robot, run.target, run.seed)) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (kept || (!name.empty() && name.back() != '-')) name += kept ? c : '-';
  }
  return name;
}

/// The worst of each combination, then the others that failed.
std::vector<std::size_t> worth_looking_at(const std::vector<SweptRun>& runs) {
  std::vector<std::size_t> order;
  for (const auto& combination : combinations_of(runs)) order.push_back(worst_of(runs, combination));
  const std::set<std::size_t> first(order.begin(), order.end());
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!runs[i].reached() && !first.contains(i)) order.push_back(i);
  std::erase_if(order, [&](std::size_t i) { return runs[i].verdict == "error"; });
  return order;
}

Shown make_again(const std::vector<SweptRun>& runs, const ReportArguments& arguments) {
  Shown shown;
  const fs::path page = arguments.out, folder = page.stem().string() + "-runs";
  const std::vector<std::size_t> order = worth_looking_at(runs);
  const std::size_t worst = combinations_of(runs).size();
  MakeAgain again(arguments.each);
  std::set<std::string> names;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k >= arguments.runs) {
      shown.not_made = order.size() - k;
      break;
    }
    const SweptRun& run = runs[order[k]];
    const auto made = again(run);
    if (!made) {
      ++shown.other;
      continue;
    }
    LeftOn& left = shown.left[run.map];
    left.floor = made->floor;
    left.places_mm.insert(left.places_mm.end(), made->left_mm.begin(), made->left_mm.end());
    ++left.runs;
    if (k >= worst) continue;
    fs::create_directories(page.parent_path() / folder);
    std::string name = name_of(run);
    if (!names.insert(name).second) name += fmt::format("-row-{}", order[k] + 1);  // "a b" and "a-b"
    const fs::path replay = folder / (name + ".html");
    write_file(page.parent_path() / replay, record::page_of(made->recording));
    shown.replays[order[k]] = replay.string();
  }
  return shown;
}

}  // namespace

int report_command(const ReportArguments& arguments) {
  const std::string text = read_file(arguments.file);
  const std::string name = fs::path(arguments.file).filename();
  const WriteClaim claim(arguments.out);
  std::string page;
  std::size_t replays = 0;
  if (text.find_first_not_of(" \t\r\n\xEF\xBB\xBF") != text.npos &&
      text[text.find_first_not_of(" \t\r\n\xEF\xBB\xBF")] == '<') {
    page = junit_page(name, read_junit(text, arguments.file));
  } else {
    const std::vector<SweptRun> runs = read_swept_runs(text, arguments.file);
    const Shown shown = make_again(runs, arguments);
    replays = shown.replays.size();
    page = sweep_page(name, runs, shown);
  }
  write_file(arguments.out, page);
  print(fmt::format("{} is written{}\n", arguments.out,
                    replays == 0
                        ? ""
                        : fmt::format(", and {} beside it",
                                      replays == 1 ? "a replay" : fmt::format("{} replays", replays))));
  return 0;
}

}  // namespace robosim::cli
