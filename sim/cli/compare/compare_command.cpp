#include "sim/cli/compare/compare_command.h"

#include "sim/base/error.h"
#include "sim/campaign/compare/comparer.h"
#include "sim/cli/compare/compare_report.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {

int compare_command(const CompareArguments& arguments) {
  terminal::Progress progress(true);
  campaign::Comparer comparer(arguments, progress, listener_of(progress, {.warnings = false}));
  for (std::uint64_t seed = arguments.first_seed;; ++seed) {
    const campaign::Compared compared = comparer.compare(seed);
    print(arguments.json ? compare_json(compared) : compare_text(compared));
    if (!compared.same()) return static_cast<int>(ExitStatus::failed);
    if (seed == arguments.last_seed) return static_cast<int>(ExitStatus::ok);
  }
}

}  // namespace robosim::cli
