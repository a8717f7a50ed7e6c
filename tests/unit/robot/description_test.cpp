#include "sim/robot/description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/describe.h"

namespace robosim::robot {
namespace {

TEST(Description, EveryStockRobotLoads) {
  for (const std::string& name : stock_robots()) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(load_description(name));
  }
}

}  // namespace
}  // namespace robosim::robot
