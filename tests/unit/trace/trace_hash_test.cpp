#include "sim/run/trace/trace_hash.h"

#include <gtest/gtest.h>

namespace robosim::trace {
namespace trace_hash_test {

std::string hash_of(int poses, double x, Pin pin, SimTime t, std::uint8_t byte) {
  TraceHash hash;
  for (int i = 0; i < poses; ++i) hash.pose({{x, i * 0.5}, {1.0, 0.0}});
  PinDrive drive;
  drive.mode = PinMode::output;
  hash.pin(pin, drive, t);
  hash.serial(byte, t);
  return hash.text();
}

TEST(TraceHash, IsPinned) {  // the hash is equal for every compiler, optimisation and architecture
  EXPECT_EQ(hash_of(1000, 1.25, 5, 1'000'000, 'A'), "1:c7e01d5d65ec9cf6");
}

TEST(TraceHash, ChangesWithEveryThingItCovers) {
  const std::string base = hash_of(10, 1.0, 5, 100, 'A');
  EXPECT_EQ(base, hash_of(10, 1.0, 5, 100, 'A'));
  EXPECT_NE(base, hash_of(11, 1.0, 5, 100, 'A'));
  EXPECT_NE(base, hash_of(10, 1.0 + 1e-15, 5, 100, 'A'));
  EXPECT_NE(base, hash_of(10, 1.0, 6, 100, 'A'));
  EXPECT_NE(base, hash_of(10, 1.0, 5, 101, 'A'));
  EXPECT_NE(base, hash_of(10, 1.0, 5, 100, 'B'));
}

TEST(TraceHash, DoesNotDependOnHowOftenItIsRead) {
  TraceHash a, b;
  for (int i = 0; i < 700; ++i) {
    a.pose({{i * 1.0, 0.0}, {1.0, 0.0}});
    b.pose({{i * 1.0, 0.0}, {1.0, 0.0}});
    b.text();
  }
  EXPECT_EQ(a.text(), b.text());
}

}  // namespace trace_hash_test
}  // namespace robosim::trace
