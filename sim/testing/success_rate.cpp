#include "robosim/testing/success_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

#include "sim/base/error.h"
#include "sim/campaign/analysis/success_rate.h"
#include "sim/launch/client/pool.h"
#include "sim/testing/artifacts.h"
#include "sim/testing/request_builder.h"

namespace robosim::testing {
namespace {

constexpr std::size_t kFailuresTold = 3;

std::size_t workers() {
  const char* jobs = std::getenv("ROBOSIM_JOBS");
  if (jobs) return std::max<std::size_t>(1, std::strtoull(jobs, nullptr, 10));
  return std::max(1u, std::thread::hardware_concurrency());
}

/// A trial can contain the map and the robot as texts, which were written to files. Removes these files.
struct Cleaner {
  const ResolvedTrial& resolved_trial;
  ~Cleaner() {
    std::error_code ignored;
    if (!resolved_trial.scratch.empty()) std::filesystem::remove_all(resolved_trial.scratch, ignored);
  }
};

void check(const analysis::Demand& demand, std::int64_t seeds) {
  if (!(demand.rate >= 0.0 && demand.rate <= 1.0))
    throw InputError(fmt::format("the success rate: expected a number from 0 to 1, got {}", demand.rate));
  if (seeds < 1) throw InputError("a success rate requires at least one seed");
  if (analysis::needed_successes(demand, seeds)) return;
  const auto needed = analysis::needed_runs(demand);
  throw InputError(
      needed ? fmt::format("{} seeds cannot prove a rate of {}, even if all succeed; {} seeds could", seeds,
                           demand.rate, *needed)
             : std::string("no number of runs can prove a rate of 1"));
}

}  // namespace

::testing::AssertionResult success_rate(const Trial& given, MinimumRate least,
                                        const std::vector<std::uint64_t>& seeds) {
  const analysis::Demand demand{least.rate, least.sure};
  check(demand, static_cast<std::int64_t>(seeds.size()));
  Trial trial = given;
  trial.target = target_of(given);
  ResolvedTrial resolved_trial = [&] {
    Borrowed runner(trial.target);
    return resolve_trial(trial, *runner);
  }();
  const Cleaner cleaner{resolved_trial};
  resolved_trial.request.samples_every_ns = 0;
  resolved_trial.request.counters.clear();  // these runs are not counted for coverage
  resolved_trial.request.serial = resolved_trial.request.notes = false;

  analysis::Tally tally(static_cast<std::int64_t>(seeds.size()), demand);
  std::string failures, problem;
  std::size_t failed = 0;
  client::Pool pool(workers());
  client::Batch batch;
  batch.count = seeds.size();
  batch.task = [&](std::size_t i) {
    wire::RunRequest request = resolved_trial.request;
    request.seed = seeds[i];
    return client::Task{trial.target, request};
  };
  batch.wanted = [&](std::size_t) { return !tally.decided() && problem.empty(); };
  batch.answered = [&](std::size_t i, client::Answer answer) {
    if (const auto* failure = std::get_if<client::Failure>(&answer)) {
      problem = failure->message;
      return;
    }
    const auto& result = std::get<result::RunResult>(answer);
    tally.add(result.verdict == "reached");
    if (result.verdict == "reached" || ++failed > kFailuresTold) return;
    failures +=
        fmt::format("\n  seed {}: {} at {:.3f} s: {}", seeds[i], result.verdict, result.time_s, result.why);
    if (failed > 1) return;
    resolved_trial.request.seed = seeds[i];
    const std::string folder = artifact_folder();
    keep_inputs(folder, resolved_trial, trial.script);
    failures += fmt::format("\n    replay: {} --for {}ms",
                            replay_command(resolved_trial, folder, !trial.script.empty()),
                            trial.limit.count() / 1'000'000);
  };
  pool.run(batch);
  if (!problem.empty()) throw std::runtime_error(problem);

  const analysis::Interval interval = tally.interval();
  const std::string found = fmt::format(
      "{} of {} runs with different seeds succeeded{}; the true rate lies between {:.1f} % and {:.1f} %",
      tally.successes(), tally.runs(),
      tally.runs() < tally.planned()
          ? fmt::format(" ({} were planned, but could not change the answer)", tally.planned())
          : "",
      100.0 * interval.low, 100.0 * interval.high);
  if (tally.met()) return ::testing::AssertionSuccess() << found;
  return ::testing::AssertionFailure()
         << fmt::format("{} on {}, target {}: {}; expected at least {:g} %", resolved_trial.sketch_title,
                        resolved_trial.map_is_text ? "the test's map" : resolved_trial.map, trial.target,
                        found, 100.0 * least.rate)
         << failures;
}

}  // namespace robosim::testing
