#include "sim/cli/check/test_arguments.h"

#include "sim/base/error.h"
#include "sim/cli/options.h"
#include "sim/cli/sweep/sweep_arguments.h"

namespace robosim::cli {

Command parse_test(const std::vector<std::string>& words) {
  TestArguments test;
  std::string jobs;
  Options options("test",
                  "Makes the checks in the checks.toml beside each sketch. The result is the same for any "
                  "number of jobs. In a checkout, ./robosim test runs Robosim's own tests.");
  options.positionals("SKETCH", test.sketches, "folders, .ino files or names; default: the current folder");
  options.text("--checks", test.checks, "FILE", "these checks for all sketches, in place of their own");
  options.text("--junit", test.junit, "FILE", "the results as JUnit XML too");
  options.text("--jobs", jobs, "N", "runs at a time; default: one for each core");
  options.flag("--untrusted", test.untrusted,
               "somebody else's sketches: on a chip, which they cannot leave, and compilers are confined");
  if (const auto help = options.parse(words)) return PrintText{*help};
  test.jobs = number_of_jobs(jobs);
  return test;
}

Command parse_new(const std::vector<std::string>& words) {
  NewArguments arguments;
  Options options(
      "new",
      "Makes a folder with a sketch that follows a line, its robot, a track and checks for robosim "
      "test.");
  options.positional("NAME", arguments.name, "of the folder and the sketch");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (arguments.name.empty()) throw InputError("robosim new needs a name, as in robosim new demo");
  return arguments;
}

}  // namespace robosim::cli
