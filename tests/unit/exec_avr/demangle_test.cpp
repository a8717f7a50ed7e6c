#include "sim/exec/elf/demangle.h"

#include <gtest/gtest.h>

namespace robosim::exec::demangle_test {

TEST(FunctionName, IsAsInTheSketchForMethodsAndTheCompilersVariants) {
  EXPECT_EQ(function_name("loop"), "loop");
  EXPECT_EQ(function_name("_ZN5Motor9set_speedEi"), "set_speed");
  EXPECT_EQ(function_name("_ZN5Motor9set_speedEi.isra.0"), "set_speed");
  EXPECT_EQ(function_name("attachInterrupt.part.0"), "attachInterrupt");
  EXPECT_EQ(function_name("_Z5drivehh.constprop.1"), "drive");
  EXPECT_EQ(function_name("__vector_7"), "__vector_7");
  EXPECT_EQ(function_name(""), "");
}

}  // namespace robosim::exec::demangle_test
