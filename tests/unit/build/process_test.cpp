#include "sim/build/process.h"

#include <gmock/gmock.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace process_test {

TEST_F(SketchTest, OutcomesStandInTheOrderOfTheCommands) {
  std::vector<Command> commands;
  for (int i = 0; i < 9; ++i)
    commands.push_back(
        {{"/bin/sh", "-c", "echo out$0; echo err$0 >&2; exit $0", std::to_string(i)}, "/", {}});
  const std::vector<CommandResult> results = run(commands);
  for (int i = 0; i < 9; ++i) {
    const std::string n = std::to_string(i);
    EXPECT_EQ(results[static_cast<std::size_t>(i)].status, i);
    EXPECT_EQ(results[static_cast<std::size_t>(i)].output, "out" + n + "\nerr" + n + "\n");
  }
}

TEST_F(SketchTest, ACommandHasItsFolderAndInput) {
  const auto input = write("input", "some text");
  EXPECT_EQ(run(Command{{"/bin/sh", "-c", "pwd; cat"}, folder_, input}).output,
            folder_.string() + "\nsome text");
  EXPECT_EQ(run(Command{{"/bin/sh", "-c", "cat"}, folder_, {}}).output, "");
}

TEST_F(SketchTest, WhatTheUserSetsInTheEnvironmentDoesNotChangeResults) {
  ::setenv("CPATH", "/somewhere", 1);
  ::setenv("LC_ALL", "de_DE.UTF-8", 1);
  const std::string output =
      run(Command{{"/bin/sh", "-c", "echo $LC_ALL,$LANG,$CPATH,$SOURCE_DATE_EPOCH"}, "/", {}}).output;
  EXPECT_EQ(output, "C,,,0\n");
}

TEST_F(SketchTest, ASignalIsSeen) {
  EXPECT_EQ(run(Command{{"/bin/sh", "-c", "kill -9 $$"}, "/", {}}).status, 128 + 9);
  EXPECT_THROW(run(Command{{"/bin/sh", "-c", "kill -2 $$"}, "/", {}}), std::runtime_error);
#ifndef ROBOSIM_EMULATED  // qemu-user does not report that a program could not be started
  EXPECT_ANY_THROW(run(Command{{"/no/such/program"}, "/", {}}));
#endif
}

}  // namespace process_test
}  // namespace robosim::build
