#include "sim/cli/hunt/hunt_arguments.h"

#include <algorithm>
#include <charconv>

#include "sim/cli/run_options.h"
#include "sim/cli/sweep/sweep_arguments.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostRuns = 1'000'000;
constexpr std::int64_t kUsual_ns = 60'000'000'000;

double minutes_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value > 0.0 && value <= 10'000.0))
    refuse_value("--minutes", text, "a number above 0, 10000 at most");
  return value;
}

}  // namespace

Command parse_hunt(const std::vector<std::string>& words) {
  HuntArguments hunt;
  std::string seed, runs, minutes, jobs, shard, duration;
  Options options(
      "hunt",
      "Looks for faults of a sketch without any test: in worlds that are drawn, with buttons, "
      "messages, faults and clocks. Tells what went wrong, and leaves the smallest run that shows it.");
  options.positional("SKETCH", hunt.sketch, "a folder, .ino file or name; default: the current folder");
  options.lists("--map", hunt.maps, "MAP...", "files, or names of sample maps; others like them are drawn");
  options.flag("--only-maps", hunt.only_maps, "these maps alone: none is drawn");
  options.text("--robot", hunt.robot, "ROBOT",
               "file, or name of a stock robot; others within its spreads are drawn");
  options.lists("--target", hunt.targets, "TARGET...",
                "host, avr, stm32; default: the board's, and the host");
  options.text("--runs", runs, "N", "how many; default 400, or with --minutes as many as that gives");
  options.text("--minutes", minutes, "N", "of wall time, after which no further run begins");
  options.text("--seed", seed, "N", "of what is drawn; default 1");
  options.text("--jobs", jobs, "N", "runs at a time; default: one for each core");
  options.text("--out", hunt.out, "DIR", "a new folder for what is found; default: hunt-SKETCH");
  options.flag("--resume", hunt.resume, "go on with the folder: its runs are not made again");
  options.text("--shard", shard, "I/N",
               "make only the I-th of N parts of the runs; --merge brings them together");
  options.lists("--merge", hunt.merge, "DIR...", "folders of the shards: tells what all of them have found");
  options.flag("--stop-early", hunt.stop_early, "end with the first finding");
  options.text("--for", duration, "TIME",
               "simulated time of a run at most, longer on long ways; default: 60s");
  options.text("--start", hunt.each.request.start, "X,Y,DIR",
               "start cell and heading; then no maps are drawn");
  options.text("--goal", hunt.each.request.goal, "GOAL", "as of run; default: the map's");
  options.text("--script", hunt.each.script, "FILE", "what happens in every run");
  RunOptions shared(options, hunt.each);
  shared.common();
  if (const auto help = options.parse(words)) return PrintText{*help};
  hunt.jobs = number_of_jobs(jobs);
  if (!shard.empty()) hunt.shard = read_shard(shard);
  if (!hunt.merge.empty() && (hunt.resume || !shard.empty()))
    throw InputError("--merge makes no runs; it goes without --resume and --shard");
  if (!seed.empty()) hunt.seed = seed_number(seed);
  if (!minutes.empty()) hunt.minutes = minutes_of(minutes), hunt.runs = kMostRuns;
  if (!runs.empty()) hunt.runs = whole_number("--runs", runs, 1, kMostRuns);
  hunt.each.request.for_ns = duration.empty() ? kUsual_ns : simulated_time("--for", duration);
  shared.finish();
  hunt.targets = split_at_commas(hunt.targets);
  return hunt;
}

}  // namespace robosim::cli
