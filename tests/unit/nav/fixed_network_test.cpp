#include "firmware/src/nav/FixedNetwork.h"

#include <gtest/gtest.h>

namespace nav_test {
namespace {

TEST(PackedCost, IsExactBelow128AndThreePercentOffAtMostBeyond) {
  uint32_t last = 0;
  for (uint32_t cost = 0; cost <= 31744; ++cost) {
    const uint32_t kept = nav::unpackCost(nav::packCost(cost));
    if (cost < 128) {
      EXPECT_EQ(kept, cost);
    }
    EXPECT_LE(kept > cost ? kept - cost : cost - kept, cost / 32 + 1) << cost;
    EXPECT_GE(kept, last);
    last = kept;
  }
  EXPECT_EQ(nav::unpackCost(nav::packCost(31745)), 31744);
  EXPECT_EQ(nav::unpackCost(nav::packCost(4000000000u)), 31744);
}

}  // namespace
}  // namespace nav_test
