// Runs of sketches, pinned. They hold for the compiler that is named, which decides where the basic blocks of
// a sketch begin; Robosim itself may be built by any compiler, with or without optimisation.

#include <ostream>

#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

constexpr const char* kCompiler = "gcc 12.2.0 x86_64-linux-gnu";

struct Pinned {
  const char* sketch;
  const char* map;
  const char* robot;
  const char* trace_hash;
};

std::ostream& operator<<(std::ostream& out, const Pinned& pinned) { return out << pinned.sketch; }

class GoldenSketch : public testing::TestWithParam<Pinned> {};

TEST_P(GoldenSketch, RunsBitForBitAsPinned) {
  const Pinned& pinned = GetParam();
  const build::Image image = build::build({sketch_folder(pinned.sketch), *find_board("uno")});
  if (image.compiler != kCompiler)
    GTEST_SKIP() << "pinned for " << kCompiler << ", this is " << image.compiler;
  const wire::RunResult r =
      run({.sketch = pinned.sketch, .map = pinned.map, .robot = pinned.robot, .for_s = 20.0});
  EXPECT_EQ(r.trace_hash, pinned.trace_hash) << r.why;
}

INSTANTIATE_TEST_SUITE_P(Of, GoldenSketch,
                         testing::Values(Pinned{"PidFollower", "oval", "uno5", "1:544c6e6bb857f776"},
                                         Pinned{"LeftPath", "d", "uno3", "1:0ff7894b5e7caab3"},
                                         Pinned{"SpinsOnPin", "oval", "uno3", "1:de7a58ea1b8cbe66"}),
                         [](const auto& test) { return test.param.sketch; });

}  // namespace
}  // namespace robosim::test
