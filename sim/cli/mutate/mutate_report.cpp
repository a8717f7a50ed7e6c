#include "sim/cli/mutate/mutate_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace robosim::cli {
namespace {

const char* word(const mutate::Mutant& mutant) {
  switch (mutant.trial.ending) {
    case mutate::Trial::Ending::failed:
      return "found";
    case mutate::Trial::Ending::late:
      return "late";
    case mutate::Trial::Ending::passed:
      return mutant.observed ? "survived" : "unobserved";
    case mutate::Trial::Ending::not_compiled:
      return "not compiled";
    case mutate::Trial::Ending::interrupted:
      break;
  }
  return "interrupted";
}

std::string list(const std::vector<mutate::Mutant>& mutants, const std::string& which, const char* heading) {
  std::string text;
  for (const mutate::Mutant& mutant : mutants)
    if (word(mutant) == which) text += "  " + mutate::described(mutant.mutation) + "\n";
  return text.empty() ? "" : fmt::format("\n{}\n{}", heading, text);
}

nlohmann::ordered_json json_of(const mutate::Mutant& mutant) {
  const mutate::Mutation& m = mutant.mutation;
  nlohmann::ordered_json json = {{"result", word(mutant)}, {"kind", m.kind}, {"file", m.edits.front().file},
                                 {"line", m.line},         {"was", m.was},   {"now", m.now}};
  if (!mutant.trial.check.empty()) json["check"] = mutant.trial.check;
  if (!mutant.trial.why.empty()) json["why"] = mutant.trial.why;
  return json;
}

}  // namespace

std::string mutation_text(const mutate::MutationResult& result) {
  const std::size_t observed = result.mutants.size() - result.unobserved();
  std::string text =
      fmt::format("{}: {} small bugs, drawn by seed {} from {}; {} more did not compile\n", result.sketch,
                  result.mutants.size(), result.seed, result.places, result.not_compiled);
  text += fmt::format("found {} of {} ({:.0f} %), {} of them because time was up\n", result.found(), observed,
                      100.0 * result.score(), result.count(mutate::Trial::Ending::late));
  if (result.unobserved() > 0)
    text += fmt::format("{} more changed nothing in any run\n", result.unobserved());
  text += list(result.mutants, "survived", fmt::format("no {} fails:", result.asked).c_str());
  text += list(result.mutants, "unobserved", "without any effect in these runs:");
  for (const mutate::Mutant& control : result.controls)
    if (control.trial.ending != mutate::Trial::Ending::passed)
      text += fmt::format("\nbrittle: the {} \"{}\" fails where it should not, with {} at {}: {}\n",
                          result.asked, control.trial.check, mutate::what(control.mutation),
                          mutate::where(control.mutation), control.trial.why);
  if (!result.controls.empty() && result.brittle() == 0)
    text += fmt::format("\n{} harmless changes: all {}s pass, as they should\n", result.controls.size(),
                        result.asked);
  if (!result.complete) text += "interrupted: the results are incomplete\n";
  return text;
}

std::string mutation_json(const mutate::MutationResult& result) {
  nlohmann::ordered_json json = {
      {"schema", "robosim.mutate/1"},
      {"sketch", result.sketch},
      {result.asked == "test" ? "tests" : "checks", result.checks},
      {"seed", result.seed},
      {"places", result.places},
      {"not_compiled", result.not_compiled},
      {"found", result.found()},
      {"late", result.count(mutate::Trial::Ending::late)},
      {"unobserved", result.unobserved()},
      {"survived", result.count(mutate::Trial::Ending::passed) - result.unobserved()},
      {"score", result.score()},
      {"complete", result.complete}};
  for (const auto& [name, mutants] :
       {std::pair{"mutants", &result.mutants}, std::pair{"controls", &result.controls}}) {
    json[name] = nlohmann::ordered_json::array();
    for (const mutate::Mutant& mutant : *mutants) json[name].push_back(json_of(mutant));
  }
  return json.dump(2) + "\n";
}

}  // namespace robosim::cli
