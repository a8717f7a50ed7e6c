#include "sim/cli/hunt/hunt_arguments.h"

#include <algorithm>
#include <charconv>

#include "sim/cli/run_options.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostRuns = 1'000'000;
constexpr std::int64_t kUsual_ns = 60'000'000'000;

double minutes_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value > 0.0 && value <= 10'000.0))
    refuse_value("--minutes", text, "a number above 0, at most 10000");
  return value;
}

}  // namespace

Command parse_hunt(const std::vector<std::string>& words) {
  HuntArguments hunt;
  std::string seed, runs, minutes, jobs, shard, duration;
  Options options("hunt", "search for bugs automatically: random worlds, inputs and faults",
                  "Needs no test. Reports what went wrong, and writes the smallest run that shows it.");
  options.positional("[SKETCH]", hunt.sketch, kSketchHelp, PossibleValues::sketch());
  options.lists("--map", hunt.maps, "MAP",
                "use these maps, and random ones like them: files, or names of sample maps",
                PossibleValues::map());
  options.flag("--only-maps", hunt.only_maps, "use the maps of --map only, and no random ones");
  options.text("--robot", hunt.robot, "ROBOT",
               "use this robot, and random ones within its spreads: a file, or the name of a stock robot",
               PossibleValues::robot());
  options.lists("--target", hunt.targets, "TARGET",
                "execute on host, avr or stm32 (default: the board's chip and the host)", targets());
  options.text("--runs", runs, "N",
               "do this many runs (default: 400; with --minutes, as many as fit into that time)");
  options.text("--minutes", minutes, "N", "begin no run after N minutes of wall time");
  options.text("--seed", seed, "N", "seed all random choices (default: 1)");
  options.text("--jobs", jobs, "N", kJobsHelp);
  options.text("--out", hunt.out, "DIR", "write findings into this new folder (default: hunt-SKETCH)",
               PossibleValues::folder());
  options.flag("--resume", hunt.resume, "continue the hunt in the folder of --out; skip its finished runs");
  options.text("--shard", shard, "I/N", kShardHelp);
  options.lists("--merge", hunt.merge, "DIR", "report the findings of all these folders of --shard",
                PossibleValues::folder());
  options.flag("--stop-early", hunt.stop_early, "end with the first finding");
  options.text("--for", duration, "TIME",
               "limit the simulated time of each run (default: 60s); runs on long ways get more");
  options.text("--start", hunt.each.request.start, "X,Y,DIR",
               "start in this cell and heading, on the maps of --map only");
  options.text("--goal", hunt.each.request.goal, "GOAL",
               "pursue this goal, as in run --goal (default: the map's)", goals());
  options.text("--script", hunt.each.script, "FILE", "apply this script during every run",
               PossibleValues::file());
  RunOptions shared(options, hunt.each);
  shared.common();
  if (const auto help = options.parse(words)) return *help;
  hunt.jobs = number_of_jobs(jobs);
  if (!shard.empty()) hunt.shard = campaign::read_shard(shard);
  if (!hunt.merge.empty() && (hunt.resume || !shard.empty()))
    throw InputError("--merge does no runs; it excludes --resume and --shard");
  if (!seed.empty()) hunt.seed = seed_number(seed);
  if (!minutes.empty()) hunt.minutes = minutes_of(minutes), hunt.runs = kMostRuns;
  if (!runs.empty()) hunt.runs = whole_number("--runs", runs, 1, kMostRuns);
  hunt.each.request.for_ns = duration.empty() ? kUsual_ns : simulated_time("--for", duration);
  shared.finish();
  hunt.targets = split_at_commas(hunt.targets);
  return hunt;
}

}  // namespace robosim::cli
