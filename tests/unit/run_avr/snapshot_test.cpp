// Runs the tests of snapshots.h on target avr.
#include "sim/exec/avr/avr_executor.h"

namespace robosim::run {
namespace {

struct Target {
  using Executor = exec::AvrExecutor;
  static constexpr const char *kName = "avr", *kFive = "uno5", *kThree = "uno3";
};

}  // namespace
}  // namespace robosim::run

#include "tests/support/snapshots.h"

namespace robosim::run {
namespace {

INSTANTIATE_TEST_SUITE_P(Stock, Snapshots,
                         testing::Values(Case{"PidFollower", "uno5", "oval", "13,14", kFiveSensors.c_str()},
                                         Case{"LeftPath", "uno3", "d", "6,10", kThreeSensors.c_str()},
                                         Case{"RightPath", "uno3", "a", "6,4", kThreeSensors.c_str()},
                                         Case{"AiNavigator", "uno5", "b", "6,10", kFiveSensors.c_str()},
                                         Case{"PonyNavigator", "pony", "city", "7,24", kPony.c_str()}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

INSTANTIATE_TEST_SUITE_P(OfOtherChips, Snapshots,
                         testing::Values(Case{"MegaFollower", "mega5", "oval", "13,14", kFiveSensors.c_str()},
                                         Case{"LeonardoFollower", "leonardo5", "oval", "13,14",
                                              kFiveSensors.c_str()}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

INSTANTIATE_TEST_SUITE_P(Driven, Snapshots,
                         testing::Values(Case{"PidFollower", "uno5", "oval", "13,14", "", true},
                                         Case{"MegaFollower", "mega5", "oval", "13,14", "", true}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace
}  // namespace robosim::run
