// Compares traces of sketches with stored hashes. Each compiler has its own hashes, because it decides where
// the basic blocks of a sketch begin. Robosim itself may be built by any compiler, with or without
// optimisation.

#include <ostream>

#include "tests/system/system_test.h"

namespace robosim::test {
namespace golden_test {

struct Pinned {
  const char* sketch;
  const char* map;
  const char* robot;
  const char *by_gcc_12, *by_gcc_14;  ///< hash of the trace
};

std::ostream& operator<<(std::ostream& out, const Pinned& pinned) { return out << pinned.sketch; }

class GoldenSketch : public testing::TestWithParam<Pinned> {};

TEST_P(GoldenSketch, RunsBitForBitAsPinned) {
  const Pinned& pinned = GetParam();
  const std::string compiler = build::build({sketch_folder(pinned.sketch), *find_board("uno")}).compiler;
  const char* const hash = compiler == "gcc 12.2.0 x86_64-linux-gnu"   ? pinned.by_gcc_12
                           : compiler == "gcc 14.2.0 x86_64-linux-gnu" ? pinned.by_gcc_14
                                                                       : nullptr;
  if (!hash) GTEST_SKIP() << "pinned for the compilers of Debian 12 and 13, but this is " << compiler;
  const result::RunResult r =
      run({.sketch = pinned.sketch, .map = pinned.map, .robot = pinned.robot, .for_s = 20.0});
  EXPECT_EQ(r.trace_hash, hash) << r.why;
}

INSTANTIATE_TEST_SUITE_P(
    Of, GoldenSketch,
    testing::Values(Pinned{"PidFollower", "oval", "uno5", "1:544c6e6bb857f776", "1:a17a756c425bacc9"},
                    Pinned{"LeftPath", "d", "uno3", "1:0ff7894b5e7caab3", "1:a96e086aaaa65e13"},
                    Pinned{"SpinsOnPin", "oval", "uno3", "1:de7a58ea1b8cbe66", "1:de7a58ea1b8cbe66"}),
    [](const auto& test) { return test.param.sketch; });

}  // namespace golden_test
}  // namespace robosim::test
