// Runs the tests of snapshots.h on target stm32.
#include "sim/exec/stm32/stm32_executor.h"

namespace robosim::run {
namespace {

struct Target {
  using Executor = exec::Stm32Executor;
  static constexpr const char *kName = "stm32", *kFive = "bluepill5", *kThree = "bluepill3";
};

}  // namespace
}  // namespace robosim::run

#include "tests/support/snapshots.h"

namespace robosim::run {
namespace {

INSTANTIATE_TEST_SUITE_P(Stock, Snapshots,
                         testing::Values(Case{"PidFollower", "bluepill5", "oval", "13,14",
                                              kFiveSensors.c_str()},
                                         Case{"LeftPath", "bluepill3", "d", "6,10", kThreeSensors.c_str()},
                                         Case{"RightPath", "bluepill3", "a", "6,4", kThreeSensors.c_str()},
                                         Case{"AiNavigator", "bluepill5", "b", "6,10", kFiveSensors.c_str()},
                                         Case{"PonyNavigator", "bluepony", "city", "7,24", kPony.c_str()}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

INSTANTIATE_TEST_SUITE_P(Driven, Snapshots,
                         testing::Values(Case{"PidFollower", "bluepill5", "oval", "13,14", "", true}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace
}  // namespace robosim::run
