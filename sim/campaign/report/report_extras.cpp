#include "sim/campaign/report/report_extras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <tuple>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/launch/names.h"
#include "sim/record/record_page.h"

namespace robosim::campaign {
namespace {

namespace fs = std::filesystem;

/// Writes replays into a folder next to the page, each with its own file name.
class Replays {
 public:
  explicit Replays(const std::string& page)
      : beside_(fs::path(page).parent_path()), folder_(fs::path(page).stem().string() + "-runs") {}

  /// Writes a replay and returns its link. If the name is in use, adds the run's `number` to the name.
  std::string write(const std::string& title, std::size_t number, const std::string& recording) {
    std::string name;
    for (const char c : title) {
      const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0;
      if (kept || (!name.empty() && name.back() != '-')) name += kept ? c : '-';
    }
    if (!names_.insert(name).second) name += fmt::format("-row-{}", number + 1);  // names may be equal
    std::error_code none;
    if (fs::is_symlink(beside_ / folder_, none))
      throw InputError({(beside_ / folder_).string()}, "a link: expected a folder for replays");
    fs::create_directories(beside_ / folder_);
    const fs::path file = beside_ / folder_ / (name + ".html");
    write_file(file, record::page_of(recording));
    return link_to(file, beside_);
  }

 private:
  fs::path beside_, folder_;
  std::set<std::string> names_;
};

/// Returns the worst run of each combination, then the other failed runs.
std::vector<std::size_t> worth_looking_at(const std::vector<SweptRun>& runs) {
  std::vector<std::size_t> order;
  for (const auto& combination : combinations_of(runs)) order.push_back(worst_of(runs, combination));
  const std::set<std::size_t> first(order.begin(), order.end());
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!runs[i].reached() && !first.contains(i)) order.push_back(i);
  std::erase_if(order, [&](std::size_t i) { return runs[i].verdict == "error"; });
  return order;
}

/// Returns the first failed case of each sketch, then the other failed cases.
std::vector<std::size_t> worth_looking_at(const std::vector<JunitCase>& cases) {
  std::vector<std::size_t> order, others;
  std::set<std::string> groups;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].ending == JunitCase::Ending::failed)
      (groups.insert(cases[i].group).second ? order : others).push_back(i);
  order.insert(order.end(), others.begin(), others.end());
  return order;
}

/// Returns the page that a test has saved under a path relative to its working folder. Searches the current
/// folder, then the XML's folder and its parents, because ctest runs in the build folder.
fs::path found(const fs::path& named, const fs::path& xml) {
  std::error_code error;
  if (named.is_absolute() || fs::is_regular_file(named, error)) return named;
  fs::path folder = fs::absolute(xml, error).parent_path();
  for (int up = 0; up < 3; ++up, folder = folder.parent_path())
    if (fs::is_regular_file(folder / named, error)) return folder / named;
  return named;
}

/// Repeats the run of a table row that has no command, with the sweep's options.
std::optional<std::string> made_by_options(Rerun& again, const SweptRun& run,
                                           const launch::RunSettings& each) {
  launch::RunSettings options = each;
  options.request.seed = run.seed;
  if (launch::is_fleet_file(run.sketch)) {
    launch::Fleet fleet = launch::read_fleet(run.sketch);
    fleet.map = run.map;
    launch::fill_up(fleet, options);
    return again(fleet, options.request, run.trace_hash);
  }
  launch::Launch launch = launch::launch_of(options);
  launch.sketch = run.sketch;
  launch.map = run.map;
  launch.robot = run.robot;
  launch.target = run.target;
  // In a table, names of default files are relative to the sketch's folder.
  const fs::path folder = launch::choose_sketch(run.sketch, launch.environment, launch.untrusted).folder;
  std::error_code error;
  for (std::string* name : {&launch.map, &launch.robot})
    if (launch::is_path(*name) && !fs::exists(*name, error) && fs::exists(folder / *name, error))
      *name = (folder / *name).string();
  return again(launch, run.trace_hash);
}

/// Repeats the run of a command.
std::optional<std::string> made_again(Rerun& again, const launch::RunSettings& run,
                                      const std::string& trace_hash) {
  return run.fleet.members.empty() ? again(launch_of(run), trace_hash)
                                   : again(run.fleet, run.request, trace_hash);
}

}  // namespace

void ReportExtras::add(const RecordingExtract& extract) {
  if (!extract.floor) return;
  const auto [place, added] = places_.try_emplace(extract.map_text, left.size());
  if (added) left.push_back({extract.map, *extract.floor, {}, 0});
  LeftOn& on = left[place->second];
  if (on.map != extract.map) on.map = fs::path(on.map).filename();  // the map has copies in several folders
  on.places_mm.insert(on.places_mm.end(), extract.left_mm.begin(), extract.left_mm.end());
  ++on.runs;
}

ReportExtras extras_of_runs(const std::vector<SweptRun>& runs, const ReportOptions& options,
                            const ReadCommand& read_command, const launch::Listener& listener) {
  ReportExtras extras;
  const std::vector<std::size_t> order = worth_looking_at(runs);
  const std::size_t worst = combinations_of(runs).size();
  Rerun again(listener);
  Replays replays(options.out);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k >= options.runs) {
      extras.not_made = order.size() - k;
      break;
    }
    const SweptRun& run = runs[order[k]];
    const auto made = run.command.empty() ? made_by_options(again, run, options.each)
                                          : made_again(again, read_command(run.command), run.trace_hash);
    if (!made) {
      ++extras.other;
      continue;
    }
    extras.add(extract_of(record::Recording::decode(*made, "the recording")));
    if (k >= worst) continue;
    extras.replays[order[k]] = replays.write(
        fmt::format("{} {} {} {} {}", run.sketch, run.map, run.robot, run.target, run.seed), order[k], *made);
    ++extras.written;
  }
  return extras;
}

ReportExtras extras_of_cases(const std::vector<JunitCase>& cases, const std::string& file,
                             const ReportOptions& options, const ReadCommand& read_command,
                             const launch::Listener& listener) {
  ReportExtras extras;
  Rerun again(listener);
  Replays replays(options.out);
  std::size_t looked_at = 0;
  for (const std::size_t i : worth_looking_at(cases)) {
    const JunitCase& one = cases[i];
    const std::string kept = kept_page(one.message);
    if (kept.empty() && one.again.empty()) continue;
    if (looked_at == options.runs) {
      ++extras.not_made;
      continue;
    }
    ++looked_at;
    try {
      if (!kept.empty()) {
        const fs::path page = found(kept, file);
        extras.add(extract_of(record::Recording::read(page)));
        extras.replays[i] = link_to(page, fs::path(options.out).parent_path());
        continue;
      }
      const auto made = made_again(again, read_command(one.again), one.trace_hash);
      if (!made) {
        ++extras.other;
        continue;
      }
      extras.add(extract_of(record::Recording::decode(*made, "the recording")));
      extras.replays[i] = replays.write(one.group + " " + one.name, i, *made);
      ++extras.written;
    } catch (const std::runtime_error& error) {
      const bool expected =
          dynamic_cast<const InputError*>(&error) || dynamic_cast<const ToolMissing*>(&error);
      if (!expected) throw;
      if (extras.cannot_be++ == 0) extras.cannot = error.what();
    }
  }
  return extras;
}

std::string link_to(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path near = fs::proximate(file, folder.empty() ? fs::path(".") : folder, error);
  std::string link;
  for (const char c : (error || near.empty() ? file : near).generic_string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> places;
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SweptRun& r = runs[i];
    const auto [place, added] = places.try_emplace({r.sketch, r.map, r.robot, r.target}, all.size());
    if (added) all.emplace_back();
    all[place->second].push_back(i);
  }
  return all;
}

std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination) {
  const auto badness = [&](std::size_t i) {  // smaller is worse
    const SweptRun& run = runs[i];
    if (run.verdict == "error") return std::tuple(2, 0.0, 0.0, 0.0);  // there is no run to show
    if (run.reached()) return std::tuple(1, -run.time_s, 0.0, -run.cross_track_max_mm);
    return std::tuple(0, run.laps + run.stations, run.distance_m, -run.cross_track_max_mm);
  };
  return *std::min_element(combination.begin(), combination.end(),
                           [&](std::size_t a, std::size_t b) { return badness(a) < badness(b); });
}

}  // namespace robosim::campaign
