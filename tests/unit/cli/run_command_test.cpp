#include "sim/cli/run/run_command.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace robosim::cli::run_command_test {

TEST(RunCommand, RefusesWhatCannotWorkBeforeItStartsAnything) {
  RunArguments arguments;
  arguments.record = {"a.gif"};
  EXPECT_THROW(run_command(arguments), InputError);
  arguments = {};
  arguments.sketch = "PidFollower";
  arguments.target = "mars";
  EXPECT_THROW(run_command(arguments), InputError);
}

}  // namespace robosim::cli::run_command_test
