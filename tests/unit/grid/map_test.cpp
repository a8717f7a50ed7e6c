#include "sim/grid/map.h"

#include <gmock/gmock.h>

#include "sim/base/file.h"

namespace robosim::grid {
namespace {

using ::testing::HasSubstr;

TEST(FindMap, NamesTheSamplesThatExist) {
  try {
    find_map("ovall");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("oval"));
  }
  EXPECT_EQ(read_map(find_map("oval")).name, "oval");
}

}  // namespace
}  // namespace robosim::grid
