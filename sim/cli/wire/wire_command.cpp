#include "sim/cli/wire/wire_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/build/cache.h"
#include "sim/campaign/wiring/candidate_trial.h"
#include "sim/cli/launching.h"
#include "sim/cli/options.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

const BoardSpec& board_named(const std::string& name) {
  std::vector<std::string> names;
  for (int i = 0; board_at(i) != nullptr; ++i) names.emplace_back(board_at(i)->name);
  check_choice("--board", name, names);
  return *find_board(name.c_str());
}

std::string what_came_of_it(const wiring::Trial& trial, const std::string& map) {
  const result::RunResult& result = trial.result;
  if (result.verdict == "reached" && !trial.follows)
    return fmt::format(
        "With this robot the sketch drives around the map {}, but hardly along the line: the sensors are "
        "{:.0f} mm off the line on average, and for {:.0f} of {:.0f} s no sensor saw the line.",
        map, result.metrics.cross_track_rms_mm, result.metrics.off_line_s, result.time_s);
  if (result.verdict == "reached")
    return fmt::format("With this robot the sketch drives a lap of the map {} in {:.1f} s.", map,
                       result.metrics.laps_s.empty() ? result.time_s : result.metrics.laps_s[0]);
  return fmt::format("With this robot the sketch does not drive a lap of the map {}: {}", map, result.why);
}

const wiring::Trial& chosen(const std::vector<wiring::Trial>& trials, const wiring::Ways& ways) {
  return *std::find_if(trials.begin(), trials.end(),
                       [&](const wiring::Trial& trial) { return trial.ways == ways; });
}

// Returns the trials as comments: first the chosen one, then the others, the most successful first.
std::string table_of(std::vector<wiring::Trial> trials, const wiring::RobotDraft& draft,
                     const std::string& map) {
  constexpr std::size_t kMost = 12;
  std::string text =
      fmt::format("\n# {} wirings were tried on the map {}. The sketch followed this length of the line:\n",
                  trials.size(), map);
  const auto is_chosen = [&](const wiring::Trial& trial) { return trial.ways == draft.ways; };
  std::stable_sort(trials.begin(), trials.end(), [&](const wiring::Trial& a, const wiring::Trial& b) {
    return is_chosen(a) != is_chosen(b) ? is_chosen(a) : a.followed_m > b.followed_m;
  });
  for (std::size_t i = 0; i < std::min(trials.size(), kMost); ++i)
    text += fmt::format("#   {:5.2f} m  {}{}{}\n", trials[i].followed_m, wiring::text_of(trials[i].ways),
                        trials[i].follows ? "; a whole lap" : "", i == 0 ? " (this draft)" : "");
  if (trials.size() > kMost)
    text += fmt::format("#   {} more wirings: at most {:.2f} m\n", trials.size() - kMost,
                        trials[kMost].followed_m);
  std::string open;
  for (const wiring::Way& way : wiring::kWays)
    if (draft.open.*way.is) open += fmt::format("{}{}", open.empty() ? "" : ", ", way.words);
  if (!trials.front().follows && draft.ways == wiring::Ways{})
    text += fmt::format("# ? None is much better than the first guess, so these remain open: {}\n", open);
  else if (draft.ways != wiring::Ways{})
    text += fmt::format("# ? Decided by trials alone, so check: {}\n", open);
  return text;
}

struct Drafted {
  wiring::RobotDraft draft;
  std::vector<wiring::Trial> trials;
};

Drafted drafted_on(const std::string& target, const WireArguments& arguments, const BoardSpec& board) {
  launch::Launch launch;
  launch.environment = arguments.environment;
  launch.sketch = arguments.sketch;
  launch.map = arguments.map;
  launch.target = target;
  launch.libraries = arguments.libraries;
  terminal::Progress progress(true);
  const build::Cache cache(build::cache_folder());
  const build::WorkFolder scratch(cache);
  wiring::CandidateTrial try_out(launch, board, scratch.path(),
                                 listener_of(progress, {.choices = false, .warnings = false}));
  progress.say("watching the sketch's pins …");
  wiring::RobotDraft draft = try_out.draft();
  progress.say("trying polarities and sides …");
  std::vector<wiring::Trial> trials = try_out.choose(draft);
  progress.clear();
  return {std::move(draft), std::move(trials)};
}

// Drafts the robot with runs on the given target. Without --target, runs on the host, or on the AVR if the
// sketch compiles only for it.
Drafted drafted(const WireArguments& arguments, const BoardSpec& board) {
  if (!arguments.target.empty()) return drafted_on(arguments.target, arguments, board);
  try {
    return drafted_on("host", arguments, board);
  } catch (const build::MissingLibrary&) {
    throw;
  } catch (const build::CompileError&) {
    const std::exception_ptr on_host = std::current_exception();
    try {
      return drafted_on("avr", arguments, board);
    } catch (const InputError&) {
      std::rethrow_exception(on_host);
    }
  }
}

}  // namespace

int wire_command(const WireArguments& arguments) {
  if (!arguments.out.empty() && fs::exists(arguments.out))
    throw InputError({arguments.out, 0, 0},
                     "exists already; nothing was written; remove it, or name another --out");
  if (!arguments.out.empty()) check_can_be_written(arguments.out);
  const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch, arguments.environment);
  if (arguments.board.empty()) project::check_board(sketch.project);
  const bool is_guessed = arguments.board.empty() && !sketch.project.board;
  const wiring::GuessedBoard guessed = is_guessed ? wiring::board_for(sketch) : wiring::GuessedBoard();
  const BoardSpec& board = is_guessed                ? *guessed.board
                           : arguments.board.empty() ? *sketch.project.board
                                                     : board_named(arguments.board);
  auto [draft, trials] = drafted(arguments, board);
  draft.board_doubt = guessed.doubt;

  std::vector<std::string> remarks = {
      "Drafted by `robosim wire` from the sketch's names and from its use of the pins in a run.",
      "Look at every line with a question mark. Keys and units: docs/reference/robots.md, \"Your robot, step "
      "by step\"."};
  if (!draft.parts.empty()) remarks.push_back(what_came_of_it(chosen(trials, draft.ways), arguments.map));
  const std::string text =
      wiring::text_of(draft, remarks) + (trials.size() > 1 ? table_of(trials, draft, arguments.map) : "");
  if (arguments.out.empty()) {
    print(text);
  } else {
    write_file(arguments.out, text);
    print(arguments.out + " is written; look at its lines with a question mark\n");
  }
  return 0;
}

}  // namespace robosim::cli
