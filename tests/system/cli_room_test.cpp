// Tests the report of free memory after a run on the chip, with sketches that use the memory up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_room_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

class CliRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    needs_target("avr");
    folder_.write("press", "at 300ms press start 100ms\n");
  }

  /// Runs AiNavigator with memory for `nodes` nodes of its map, and with `ballast` unused bytes.
  Ended scan_with(int nodes, int ballast) {
    const std::filesystem::path own = sketch_folder("AiNavigator");
    for (const char* header : {"Memory.h", "Walker.h"})
      folder_.write(std::string("Copy/") + header, read_file(own / header));
    folder_.write("Copy/Copy.ino", "#define LINEKIT_TREE_NODES " + std::to_string(nodes) + "\n" +
                                       read_file(own / "AiNavigator.ino") + "\nbyte ballast[" +
                                       std::to_string(ballast) + "] __attribute__((used));\n");
    return robosim_command({"run", "Copy/", "--map", "b", "--robot", "uno5", "--target", "avr", "--goal",
                            "none", "--script", "press", "--for", "12s"},
                           folder_.path());
  }

  /// Returns the reported number of nodes that fit.
  static int said(const Ended& run) {
    const std::size_t at = run.out.find("with this stack ");
    int nodes = 0;
    if (at != std::string::npos) std::sscanf(run.out.c_str() + at, "with this stack %d", &nodes);
    return nodes;
  }

  Folder folder_;
};

TEST_F(CliRoom, SoManyNodesFitIntoAiNavigatorAsItsRunSays) {
  constexpr int kBallast_bytes = 100;
  const Ended run = scan_with(200, kBallast_bytes);
  EXPECT_THAT(run.out, AllOf(HasSubstr("flash "), HasSubstr("variables "), HasSubstr("stack "),
                             HasSubstr("bytes of RAM never used")));
  const int nodes = said(run);
  EXPECT_GT(nodes, 205) << run.out;
  EXPECT_LT(nodes, 253) << run.out;
  // Not every run has an interrupt while the stack is deepest, so the test reserves memory for a handler's
  // frame.
  constexpr int kNodesOfAHandler = 8;
  const Ended full = scan_with(nodes - kNodesOfAHandler, kBallast_bytes);
  EXPECT_EQ(full.status, 0) << full.out << full.err;
  const Ended over = scan_with(nodes + 8, kBallast_bytes);
  EXPECT_EQ(over.status, 1);
  EXPECT_THAT(over.out, HasSubstr("crashed: The sketch crashed: stack overflow"));
}

TEST_F(CliRoom, AiNavigatorAsItIsCouldHoldAllNodesThatOneByteNumbers) {
  EXPECT_EQ(said(scan_with(253, 0)), 253);
  EXPECT_THAT(scan_with(254, 0).err, HasSubstr("1 to 253 nodes"));
}

}  // namespace cli_room_test
}  // namespace robosim::test
