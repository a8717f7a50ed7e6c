#include "sim/cli/check/test_arguments.h"

#include "sim/base/error.h"
#include "sim/cli/options.h"

namespace robosim::cli {

Command parse_test(const std::vector<std::string>& words) {
  TestArguments test;
  std::string jobs;
  Options options("test", "run the checks in the checks.toml next to a sketch",
                  "The result is the same for any number of jobs. In a checkout of Robosim, ./robosim test "
                  "runs Robosim's own tests.");
  options.positionals("[SKETCH]", test.sketches,
                      "test these sketches: folders, .ino files or names of sample sketches (default: the "
                      "current folder)",
                      PossibleValues::sketch());
  options.text("--checks", test.checks, "FILE",
               "run the checks of this file on all sketches, instead of their own", PossibleValues::file());
  options.text("--junit", test.junit, "FILE", "also write the results to this file, as JUnit XML",
               PossibleValues::file());
  options.texts("--libraries", test.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
  options.text("--jobs", jobs, "N", kJobsHelp);
  options.flag("--untrusted", test.untrusted,
               "treat the sketches as hostile: run them on a chip, which they cannot leave, and confine the "
               "compilers");
  if (const auto help = options.parse(words)) return *help;
  test.jobs = number_of_jobs(jobs);
  return test;
}

Command parse_new(const std::vector<std::string>& words) {
  NewArguments arguments;
  Options options("new", "create a project: a line follower, its robot, a track and checks");
  options.positional("NAME", arguments.name, "name the folder and the sketch");
  if (const auto help = options.parse(words)) return *help;
  if (arguments.name.empty()) throw InputError("robosim new requires a name, as in robosim new demo");
  return arguments;
}

}  // namespace robosim::cli
