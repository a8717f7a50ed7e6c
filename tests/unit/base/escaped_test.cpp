#include "sim/base/escaped.h"

#include <gtest/gtest.h>

namespace robosim::escaped_test {

TEST(Escaped, WhatAScriptCannotHoldBetweenItsQuotesIsEscaped) {
  EXPECT_EQ(escaped("say \"hi\"\r\n\tC:\\"), R"(say \"hi\"\r\n\tC:\\)");
  EXPECT_EQ(escaped("plain, é and all"), "plain, é and all");
}

}  // namespace robosim::escaped_test
