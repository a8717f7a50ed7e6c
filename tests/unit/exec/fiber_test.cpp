#include "sim/exec/host/fiber.h"

#include <gtest/gtest.h>

namespace robosim::exec::fiber_test {

struct Counter {
  Fiber* fiber = nullptr;
  int count = 0;
};

void count_up(void* argument) {
  auto& counter = *static_cast<Counter*>(argument);
  for (;;) {
    ++counter.count;
    counter.fiber->suspend();
  }
}

TEST(Fiber, ContinuesWhereItSuspended) {
  const GuardedMemory stack(64 * 1024);
  Counter counter;
  Fiber fiber(stack, count_up, &counter);
  counter.fiber = &fiber;
  EXPECT_EQ(counter.count, 0);
  for (int turn = 1; turn <= 3; ++turn) {
    fiber.resume();
    EXPECT_EQ(counter.count, turn);
  }
}

TEST(GuardedMemory, HoldsWhatWasAskedForAndKnowsItsGuard) {
  const GuardedMemory memory(10000);
  EXPECT_GE(memory.size(), 10000u);
  memory.begin()[0] = memory.end()[-1] = std::byte{1};
  EXPECT_TRUE(memory.contains(memory.begin()));
  EXPECT_FALSE(memory.contains(memory.end()));
  EXPECT_TRUE(memory.in_guard_before(memory.begin() - 1));
  EXPECT_FALSE(memory.in_guard_before(memory.begin()));
}

TEST(GuardedMemoryDeathTest, NobodyCanTouchItsGuards) {
  const GuardedMemory memory(4096);
  EXPECT_DEATH(*const_cast<volatile std::byte*>(memory.begin() - 1) = std::byte{1}, "");
  EXPECT_DEATH(*const_cast<volatile std::byte*>(memory.end()) = std::byte{1}, "");
}

}  // namespace robosim::exec::fiber_test
