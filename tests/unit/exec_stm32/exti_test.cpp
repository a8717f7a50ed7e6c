// Tests the external interrupt lines (RM0008, 10.2 and 10.3).
#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::exti_test {

using namespace robosim::stm32;

class ExtiTest : public BusFixture {
 protected:
  bool had_event() { return bus_.link().nvic.take_event(); }
};

TEST_F(ExtiTest, SoftwareInterruptsLikeAnEdgeUntilItsPendingBitIsCleared) {
  enable(kIrqExti9_5);
  store(kExtiImr, 1u << 7);
  store(kExtiSwier, 1u << 7);
  EXPECT_EQ(load(kExtiPr), 1u << 7);
  EXPECT_EQ(load(kExtiSwier), 1u << 7);
  EXPECT_EQ(bus_.link().nvic.wakes(), kFirstIrq + kIrqExti9_5);
  store(kExtiPr, 1u << 7);
  EXPECT_EQ(load(kExtiSwier), 0u);
  EXPECT_TRUE(takes(kIrqExti9_5));
  EXPECT_FALSE(takes(kIrqExti9_5)) << "the line is low";
}

TEST_F(ExtiTest, ALineOfTheEventMaskWakesWithoutAnInterrupt) {
  enable(kIrqExti0);
  store(kExtiEmr, 1);
  store(kExtiRtsr, 1);
  EXPECT_EQ(load(kExtiEmr), 1u);
  board_.schedule_edge(14, true, 1000);  // PA0
  pass(4);
  EXPECT_FALSE(had_event());
  pass(4);
  EXPECT_TRUE(had_event());
  EXPECT_FALSE(had_event());
  EXPECT_FALSE(takes(kIrqExti0));
  EXPECT_EQ(load(kExtiPr), 1u);
}

// While the pin is an output, its input stays connected (RM0008, 9.1.10).
TEST_F(ExtiTest, AnOutputOfTheChipsOwnIsHeard) {
  enable(kIrqExti0);
  store(kGpioA + kBsrr, 1);
  store(kExtiImr, 1);
  store(kExtiFtsr, 1);
  store(kGpioA + kCrl, 0x44444442);  // PA0: push-pull
  pass(4);
  store(kExtiPr, 1);
  const auto drive = [&](std::uint32_t how) {
    store(kGpioA + kBsrr, how);
    pass(4);
    const bool heard = load(kExtiPr);
    store(kExtiPr, 1);
    return heard;
  };
  EXPECT_TRUE(drive(1u << 16));
  EXPECT_FALSE(drive(1u << 16));
  EXPECT_FALSE(drive(1)) << "only falling edges are enabled";
  EXPECT_TRUE(drive(1u << 16));
  store(kExtiImr, 0);
  EXPECT_FALSE(drive(1));
  EXPECT_FALSE(drive(1u << 16));
}

TEST_F(ExtiTest, TheLinesOfTheChipItselfHaveInterruptsOfTheirOwn) {
  for (const auto& [line, irq] : {std::pair{16, kIrqPvd}, {17, kIrqRtcAlarm}, {18, kIrqUsbWakeup}}) {
    enable(irq);
    store(kExtiImr, 1u << line);
    store(kExtiSwier, 1u << line);
    store(kExtiPr, 1u << line);
    EXPECT_TRUE(takes(irq)) << line;
  }
  store(kExtiImr, 0xFFFFFFFF);
  EXPECT_EQ(load(kExtiImr), 0x7FFFFu);
}

}  // namespace robosim::exec::stm32::exti_test
