#include "sim/campaign/mutate/mutation_run.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "sim/base/error.h"
#include "sim/build/parse_context.h"
#include "sim/campaign/check/checks_file.h"
#include "sim/campaign/mutate/draw.h"
#include "sim/campaign/mutate/operators.h"
#include "sim/launch/client/runner.h"

namespace robosim::mutate {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kControls = 6;

build::ParseContext read(const launch::Launch& launch, const launch::Listener& listener) {
  launch::Chosen chosen = choose(launch);
  client::Runner runner(chosen.target);
  launch::Launcher launcher(listener);
  return build::parse_context_of(launcher
                                     .prepare(
                                         launch, std::move(chosen),
                                         [&](const std::string& name) { return runner.describe_robot(name); },
                                         runner.hello())
                                     .wanted);
}

/// Parses the sketch's source as the first check builds it.
build::ParseContext read(const std::string& sketch, const campaign::Check& check,
                         const launch::Listener& listener) {
  launch::Launch launch = launch_of(check.sweep.each);
  launch.sketch = sketch;
  if (!check.sweep.maps.empty()) launch.map = check.sweep.maps.front();
  if (!check.sweep.robots.empty()) launch.robot = check.sweep.robots.front();
  const auto& targets = check.sweep.targets;
  launch.target = targets.empty() || targets.front() != "avr" ? "host" : "avr";
  return read(launch, listener);
}

/// Parses the sketch's source as built by default, or for an AVR if the sketch only compiles for an AVR.
build::ParseContext read(const std::string& sketch, const launch::Listener& listener) {
  launch::Launch launch;
  launch.sketch = sketch;
  launch.target = "host";
  try {
    return read(launch, listener);
  } catch (const InputError&) {
    launch.target = "avr";
    try {
      return read(launch, listener);
    } catch (const std::exception&) {
    }
    throw;
  }
}

std::vector<std::string> programs(const std::vector<std::string>& tests) {
  std::vector<std::string> found;
  for (const std::string& test : tests) {
    const fs::path program = fs::absolute(test);
    if (!fs::is_regular_file(program) || ::access(program.c_str(), X_OK) != 0)
      throw InputError({test}, "expected a built program of GoogleTest tests");
    found.push_back(program.string());
  }
  return found;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::size_t MutationResult::count(Trial::Ending ending) const {
  return static_cast<std::size_t>(std::count_if(mutants.begin(), mutants.end(),
                                                [&](const Mutant& m) { return m.trial.ending == ending; }));
}

std::size_t MutationResult::unobserved() const {
  return static_cast<std::size_t>(std::count_if(mutants.begin(), mutants.end(), [](const Mutant& m) {
    return m.trial.ending == Trial::Ending::passed && !m.observed;
  }));
}

std::size_t MutationResult::brittle() const {
  return static_cast<std::size_t>(std::count_if(controls.begin(), controls.end(), [](const Mutant& m) {
    return m.trial.ending != Trial::Ending::passed;
  }));
}

double MutationResult::score() const {
  const std::size_t shown = mutants.size() - unobserved();
  if (shown == 0) return mutants.empty() ? 1.0 : 0.0;  // 0: if no change affects any run, tests check nothing
  return static_cast<double>(found()) / static_cast<double>(shown);
}

MutationResult plant_bugs(const MutateOptions& options, Progress& progress,
                          const launch::Listener& listener) {
  const launch::SketchChoice choice = launch::choose_sketch(options.sketch);
  if (!choice.elf_target.empty())
    throw InputError({choice.path.string()},
                     "expected a sketch's source to put bugs into, got a compiled image");
  const bool by_tests = !options.tests.empty();
  const std::string file = by_tests                 ? joined(options.tests)
                           : options.checks.empty() ? (choice.folder / "checks.toml").string()
                                                    : options.checks;
  std::error_code error;
  if (!by_tests && !fs::exists(file, error))
    throw InputError(
        {file}, "no such file: “robosim mutate” requires a file of checks, or test programs with --tests");

  progress.say("reading the sketch");
  const Tree tree = parse(by_tests ? read(options.sketch, listener)
                                   : read(options.sketch, campaign::read_checks(file).front(), listener));
  Workbench bench(choice.folder, choice.path);
  const Workbench::Ask ask = by_tests ? ask_tests(programs(options.tests), bench)
                                      : ask_checks(fs::absolute(file).string(), options.jobs);
  const Trial unchanged = bench.try_unchanged(ask);
  if (unchanged.ending == Trial::Ending::not_compiled)
    throw InputError({choice.path.string()},
                     "a copy of only the sketch's folder cannot be tested: " + unchanged.why);
  if (unchanged.ending != Trial::Ending::passed && unchanged.check.empty())
    throw InputError({file}, unchanged.why);
  if (unchanged.ending != Trial::Ending::passed)
    throw InputError({file}, fmt::format("the {} \"{}\" fails even without a bug: {}",
                                         by_tests ? "test" : "check", unchanged.check, unchanged.why));

  MutationResult result{launch::title_of(choice), file, by_tests ? "test" : "check", options.seed};
  const std::vector<Mutation> all = shuffled(mutations(tree), options.seed, "bugs");
  result.places = all.size();
  const auto try_one = [&](const Mutation& mutation, std::vector<Mutant>& mutants) {
    Mutant mutant{mutation, bench.try_with(mutation, ask)};
    if (mutant.trial.ending == Trial::Ending::interrupted) {
      result.complete = false;
    } else if (mutant.trial.ending == Trial::Ending::not_compiled) {
      ++result.not_compiled;
    } else {
      mutant.observed = mutant.trial.traces != unchanged.traces;
      mutants.push_back(std::move(mutant));
    }
  };
  for (const Mutation& mutation : all) {
    if (!result.complete || result.mutants.size() == options.count) break;
    progress.update(
        fmt::format("bug {} of {}, {} found", result.mutants.size() + 1, options.count, result.found()));
    try_one(mutation, result.mutants);
  }
  std::vector<Mutation> harmless = shuffled(controls(tree), options.seed, "controls");
  harmless.resize(std::min(harmless.size(), kControls));
  const std::size_t left_out = result.not_compiled;
  for (const Mutation& mutation : harmless)
    if (result.complete) try_one(mutation, result.controls);
  result.not_compiled = left_out;
  progress.clear();
  return result;
}

}  // namespace robosim::mutate
