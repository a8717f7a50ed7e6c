// Implements InRandomWorlds(): runs a test in random worlds, and reduces the first failure to a small world.
#include <fmt/format.h>
#include <rapidcheck/Random.h>
#include <rapidcheck/detail/Configuration.h>
#include <rapidcheck/seq/Transform.h>  // the next header needs this header but does not include it
#include <rapidcheck/shrinkable/Operations.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "robosim/random_worlds.h"
#include "sim/testing/silent_run.h"

namespace robosim::testing {
namespace {

constexpr int kMostTries = 1'000;  // maximum number of smaller worlds to try; each takes a run

/// Returns a text that identifies a world within a search.
std::string contents(const Trial& trial) {
  return fmt::format("{}\n+{}\n+{}\n+{}", trial.map, trial.robot, trial.script, trial.seed);
}

struct Smallest {
  Trial trial;
  std::size_t steps = 0;
  int tries = 0;
};

Smallest smallest_like(const rc::Shrinkable<Trial>& failing, const std::function<void(Simulation&)>& body) {
  std::set<std::string> tried{contents(failing.value())};
  int tries = 0;
  const auto fails = [&](const Trial& trial) {
    if (tries == kMostTries || !tried.insert(contents(trial)).second) return false;
    ++tries;
    return fails_in(trial, body);
  };
  const auto [trial, steps] = rc::shrinkable::findLocalMin(failing, fails);
  return {trial, steps, tries};
}

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += "    " + line + '\n';
  return result;
}

/// Describes the random parts of a trial.
std::string description(const Trial& trial, const Worlds& worlds) {
  std::string text;
  const auto say = [&](const char* what, const std::string& value, const std::string& given) {
    if (value != given) text += fmt::format("  {}:\n{}", what, indented(value));
  };
  say("map", trial.map, worlds.trial.map);
  say("robot", trial.robot, worlds.trial.robot);
  say("script", trial.script, worlds.trial.script);
  if (worlds.seeds > 1) text += fmt::format("  seed: {}\n", trial.seed);
  return text;
}

std::string story(const Smallest& found, int number, int runs, const Worlds& worlds) {
  return fmt::format(
      "world {} of {} failed. Of {} smaller ones tried, this is the smallest that also fails ({} "
      "step{}):\n{}",
      number, runs, found.tries, found.steps, found.steps == 1 ? "" : "s", description(found.trial, worlds));
}

}  // namespace

Runs runs(int count) { return {static_cast<int>(seeds(static_cast<std::uint64_t>(count)).size())}; }

void InRandomWorlds(const Worlds& worlds, Runs runs, const std::function<void(Simulation&)>& body,
                    const char* file, int line) {
  rc::detail::Configuration usual;
  usual.testParams.seed = 1;
  usual.testParams.maxSuccess = runs.count;
  const char* chosen = std::getenv("RC_PARAMS");
  const rc::detail::TestParams params = rc::detail::configFromString(chosen ? chosen : "", usual).testParams;
  const rc::Gen<Trial> any = trials(worlds);
  rc::Random random(params.seed);
  for (int i = 1; i <= params.maxSuccess; ++i) {
    const rc::Shrinkable<Trial> world = any(random.split(), params.maxSize * i / params.maxSuccess);
    if (!fails_in(world.value(), body)) continue;
    const Smallest found = params.disableShrinking ? Smallest{world.value()} : smallest_like(world, body);
    rerun_and_report(found.trial, body, story(found, i, params.maxSuccess, worlds), file, line);
    return;
  }
}

}  // namespace robosim::testing
