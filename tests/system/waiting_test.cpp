// Tests that skipping a sketch's waits on the host (hal/host/polling.h) changes no result.
#include "tests/system/system_test.h"

namespace robosim::test {
namespace waiting_test {

class Waiting : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(In, Waiting,
                         testing::Values("PidFollower", "LeftPath", "AiNavigator", "samples/LazyTasks",
                                         "samples/RaceStates", "samples/LcdLapTime", "samples/OledLaps",
                                         "samples/PinChangeDrive", "samples/RemoteModes", "samples/SoftPwm"),
                         [](const auto& sketch) {
                           return std::filesystem::path(sketch.param).filename().string();
                         });

TEST_P(Waiting, IsLeftOutWithoutATrace) {
  std::filesystem::path sketch = GetParam();
  test::Run wanted{.sketch = sketch, .goal = "none", .for_s = 4.0};
  if (sketch.has_parent_path()) {
    sketch = std::filesystem::path(ROBOSIM_SAMPLES) / sketch.filename();
    wanted.sketch = sketch;
    wanted.robot = sketch / "robot.toml";
  }
  const wire::RunRequest request = request_of(wanted);
  const result::RunResult skipped = client::Runner("host").run(request);
  ::setenv("ROBOSIM_SKIP_WAITING", "off", 1);
  const result::RunResult whole = client::Runner("host").run(request);
  ::unsetenv("ROBOSIM_SKIP_WAITING");
  EXPECT_EQ(skipped.trace_hash, whole.trace_hash);
  EXPECT_EQ(skipped.why, whole.why);
  EXPECT_EQ(skipped.serial, whole.serial);
}

}  // namespace waiting_test
}  // namespace robosim::test
