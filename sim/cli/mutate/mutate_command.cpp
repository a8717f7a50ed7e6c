#include "sim/cli/mutate/mutate_command.h"

#include "sim/base/error.h"
#include "sim/campaign/mutate/mutation_run.h"
#include "sim/cli/launching.h"
#include "sim/cli/mutate/mutate_report.h"
#include "sim/cli/output.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {

int mutate_command(const MutateArguments& arguments) {
  terminal::Progress progress(true);
  const mutate::MutationResult result =
      mutate::plant_bugs(arguments, progress, listener_of(progress, {false, false}));
  print(arguments.json ? mutation_json(result) : mutation_text(result));
  if (!result.complete) return static_cast<int>(ExitStatus::interrupted);
  const bool good = result.brittle() == 0 && result.score() >= arguments.min_score;
  return static_cast<int>(good ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
