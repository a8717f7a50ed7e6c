#include "sim/base/profile.h"

#include <gtest/gtest.h>

namespace robosim::profile_test {

TEST(Profile, NamesOfVersionsAreReadAsTheyAreWritten) {
  for (const Profile profile : {Profile::ideal, Profile::typical_1, Profile::typical_2})
    EXPECT_EQ(profile_of(to_string(profile)), profile);
  for (const std::string name : kProfileNames) {
    if (name == "typical") continue;
    EXPECT_EQ(to_string(profile_of(name)), name);
  }
  EXPECT_EQ(profile_of("typical"), Profile::typical);
}

}  // namespace robosim::profile_test
