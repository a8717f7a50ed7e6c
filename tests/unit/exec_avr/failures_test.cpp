// Every way in which firmware can bring its chip down is told with its reason and its place. The sketches are
// those of the system tests.

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace {

using testing::HasSubstr;

class FailuresTest : public AvrTest {
 protected:
  const std::optional<Crash>& crash_of(const std::string& name, SimTime duration = kSecond) {
    build::Request request{std::filesystem::path(ROBOSIM_TEST_SKETCHES) / name, *find_board("uno")};
    request.target = "avr";
    avr_ = std::make_unique<AvrExecutor>(*find_board("uno"), build::build(request).image);
    avr_->power_on(0);
    now_ = 0;
    run(duration);
    return avr_->crash();
  }
};

TEST_F(FailuresTest, EachNamesReasonFunctionAndLine) {
  struct Case {
    const char* sketch;
    const char* reason;
    const char* function;
    int line;
  };
  for (const Case& c :
       {Case{"ChipWildRead", "read of address 0x9D56, where the chip has no memory", "look", 4},
        Case{"ChipWildWrite", "write to address 0x7630, where the chip has no memory", "put", 4},
        Case{"ChipWildCall",
             "call through a wrong function pointer to address 0x7400, where there is no code", "call", 4},
        Case{"ChipRestart", "to address 0, where a reset begins", "call", 5},
        Case{"ChipSmash", "the return address on the stack was overwritten", "copy", 10},
        Case{"ChipOpcode", "illegal instruction 0x0001", "setup", 6},
        Case{"ChipDeep", "stack overflow", "deeper", 4},
        Case{"ChipWatchdog", "the watchdog has reset the chip 3 times", "work", 6},
        Case{"ChipFlash", "write to the sketch's own flash at 0x7000", "burn", 4}}) {
    const auto& crash = crash_of(c.sketch);
    ASSERT_TRUE(crash) << c.sketch;
    EXPECT_THAT(crash->reason, HasSubstr(c.reason)) << c.sketch;
    EXPECT_EQ(crash->where.function, c.function) << c.sketch;
    EXPECT_EQ(crash->where.file, std::string(c.sketch) + ".ino");
    EXPECT_EQ(crash->where.line, c.line) << c.sketch;
    EXPECT_THAT(crash->registers, HasSubstr("SP 0x")) << c.sketch;
    EXPECT_FALSE(crash->calls.empty()) << c.sketch;
  }
}

TEST_F(FailuresTest, AHangIsNoCrashAndItsPlaceIsKnown) {
  EXPECT_FALSE(crash_of("ChipHang"));
  const Activity activity = avr_->activity();
  EXPECT_LT(activity.last_call, 25 * kMillisecond);
  EXPECT_EQ(activity.where.function, "wait");
  EXPECT_EQ(activity.where.file, "ChipHang.ino");
}

TEST_F(FailuresTest, APowerCycleBeginsAfreshAfterACrash) {
  ASSERT_TRUE(crash_of("ChipWildWrite"));
  avr_->power_on(now_);
  EXPECT_FALSE(avr_->crash());
  run(100 * kMillisecond);
  EXPECT_TRUE(avr_->crash()) << "and does the same again";
}

}  // namespace
}  // namespace robosim::exec
