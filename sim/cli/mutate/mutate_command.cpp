#include "sim/cli/mutate/mutate_command.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "sim/build/parse_context.h"
#include "sim/campaign/mutate/draw.h"
#include "sim/campaign/mutate/operators.h"
#include "sim/cli/check/checks_file.h"
#include "sim/cli/launching.h"
#include "sim/cli/mutate/mutate_report.h"
#include "sim/cli/output.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kControls = 6;

build::ParseContext read(const launch::Launch& launch, terminal::Progress& progress) {
  launch::Chosen chosen = choose(launch);
  client::Runner runner(chosen.target);
  launch::Launcher launcher(listener_of(progress, {false, false}));
  return build::parse_context_of(launcher
                                     .prepare(
                                         launch, std::move(chosen),
                                         [&](const std::string& name) { return runner.describe_robot(name); },
                                         runner.hello())
                                     .wanted);
}

/// Parses the sketch's source as the first check builds it.
build::ParseContext read(const std::string& sketch, const Check& check, terminal::Progress& progress) {
  launch::Launch launch = launch_of(check.sweep.each);
  launch.sketch = sketch;
  if (!check.sweep.maps.empty()) launch.map = check.sweep.maps.front();
  if (!check.sweep.robots.empty()) launch.robot = check.sweep.robots.front();
  const auto& targets = check.sweep.targets;
  launch.target = targets.empty() || targets.front() != "avr" ? "host" : "avr";
  return read(launch, progress);
}

/// Parses the sketch's source as built by default, or for an AVR if it only compiles there.
build::ParseContext read(const std::string& sketch, terminal::Progress& progress) {
  launch::Launch launch;
  launch.sketch = sketch;
  launch.target = "host";
  try {
    return read(launch, progress);
  } catch (const InputError&) {
    launch.target = "avr";
    try {
      return read(launch, progress);
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

int mutate_command(const MutateArguments& arguments) {
  const launch::SketchChoice choice = launch::choose_sketch(arguments.sketch);
  if (!choice.elf_target.empty())
    throw InputError({choice.path.string()},
                     "expected a sketch's source to put bugs into, got a compiled image");
  const bool by_tests = !arguments.tests.empty();
  const std::string file = by_tests                   ? joined(arguments.tests)
                           : arguments.checks.empty() ? (choice.folder / "checks.toml").string()
                                                      : arguments.checks;
  std::error_code error;
  if (!by_tests && !fs::exists(file, error))
    throw InputError(
        {file}, "no such file: robosim mutate requires checks to try, or programs of tests with --tests");

  terminal::Progress progress(true);
  progress.say("reading the sketch");
  const mutate::Tree tree =
      mutate::parse(by_tests ? read(arguments.sketch, progress)
                             : read(arguments.sketch, read_checks(file).front(), progress));
  Workbench bench(choice.folder, choice.path);
  const Workbench::Ask ask = by_tests ? ask_tests(programs(arguments.tests), bench)
                                      : ask_checks(fs::absolute(file).string(), arguments.jobs);
  const Trial unchanged = bench.try_unchanged(ask);
  if (unchanged.ending == Trial::Ending::not_compiled)
    throw InputError({choice.path.string()},
                     "a copy of the sketch's folder alone does not build: " + unchanged.why);
  if (unchanged.ending != Trial::Ending::passed && unchanged.check.empty())
    throw InputError({file}, unchanged.why);
  if (unchanged.ending != Trial::Ending::passed)
    throw InputError({file}, fmt::format("the {} \"{}\" fails even without a bug: {}",
                                         by_tests ? "test" : "check", unchanged.check, unchanged.why));

  MutationResult result{launch::title_of(choice), file, by_tests ? "test" : "check", arguments.seed};
  const std::vector<mutate::Mutation> all = mutate::shuffled(mutate::mutations(tree), arguments.seed, "bugs");
  result.places = all.size();
  const auto try_one = [&](const mutate::Mutation& mutation, std::vector<Mutant>& mutants) {
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
  for (const mutate::Mutation& mutation : all) {
    if (!result.complete || result.mutants.size() == arguments.count) break;
    progress.update(
        fmt::format("bug {} of {}, {} found", result.mutants.size() + 1, arguments.count, result.found()));
    try_one(mutation, result.mutants);
  }
  std::vector<mutate::Mutation> harmless =
      mutate::shuffled(mutate::controls(tree), arguments.seed, "controls");
  harmless.resize(std::min(harmless.size(), kControls));
  const std::size_t left_out = result.not_compiled;
  for (const mutate::Mutation& mutation : harmless)
    if (result.complete) try_one(mutation, result.controls);
  result.not_compiled = left_out;
  progress.clear();

  print(arguments.json ? mutation_json(result) : mutation_text(result));
  if (!result.complete) return static_cast<int>(ExitStatus::interrupted);
  const bool good = result.brittle() == 0 && result.score() >= arguments.min_score;
  return static_cast<int>(good ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
