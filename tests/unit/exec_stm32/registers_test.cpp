// Tests the peripherals on the Blue Pill's bus without firmware: registers, clocks, resets and interrupts.

#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "sim/exec/stm32/bus.h"

namespace robosim::exec::stm32::registers_test {

TEST(BusTest, AnAccessToWhatIsNotModelledIsNamed) {
  BoardState board(*find_board("bluepill"));
  ClockedBoard clocked(board);
  FlashMemory flash;
  Bus bus(clocked, flash, 0);
  bus.load(0x40006404, 4);
  ASSERT_TRUE(bus.unmodelled());
  EXPECT_EQ(bus.unmodelled()->what, "register 0x40006404 (CAN1)");
}

TEST(BusTest, APeripheralWithoutItsClockTakesNothing) {
  BoardState board(*find_board("bluepill"));
  ClockedBoard clocked(board);
  FlashMemory flash;
  Bus bus(clocked, flash, 0);
  bus.store(robosim::stm32::kGpioA + robosim::stm32::kCrl, 0x33333333, 4);
  EXPECT_EQ(board.drive(14).mode, PinMode::input);
  bus.store(robosim::stm32::kRccApb2Enr, robosim::stm32::kIopaEn, 4);
  bus.store(robosim::stm32::kGpioA + robosim::stm32::kCrl, 0x33333333, 4);
  EXPECT_EQ(board.drive(14).mode, PinMode::output);
}

TEST(BusTest, AResetOfAPeripheralLeavesItAsAfterPowerOn) {
  using namespace robosim::stm32;
  BoardState board(*find_board("bluepill"));
  ClockedBoard clocked(board);
  FlashMemory flash;
  Bus bus(clocked, flash, 0);
  bus.store(kRccApb2Enr, 0xFFFFFFFF, 4);
  bus.store(kRccApb1Enr, 0xFFFFFFFF, 4);
  const Address crl = kGpioA + kCrl, top = kTim3 + kTimArr;
  const std::vector<std::pair<Address, std::uint32_t>> registers = {
      {crl, 0x33333333}, {top, 99},           {kAdcSqr3, 5},
      {kUsartBrr, 625},  {kAfioExticr1, 0x1}, {kTim1 + kTimPsc, 7}};
  std::vector<std::uint32_t> at_first;
  for (const auto& [address, value] : registers) {
    at_first.push_back(bus.load(address, 4));
    bus.store(address, value, 4);
    EXPECT_EQ(bus.load(address, 4), value);
  }
  EXPECT_EQ(board.drive(14).mode, PinMode::output);
  bus.store(kRccApb1Rstr, clock_bit(kTim3), 4);
  EXPECT_EQ(bus.load(top, 4), 0xFFFFu);
  EXPECT_EQ(bus.load(crl, 4), 0x33333333u) << "another peripheral";
  bus.store(top, 50, 4);
  EXPECT_EQ(bus.load(top, 4), 0xFFFFu) << "the timer is held in reset";
  bus.store(kRccApb1Rstr, 0, 4);
  bus.store(top, 50, 4);
  EXPECT_EQ(bus.load(top, 4), 50u);
  for (const std::uint32_t bits : {0xFFFFFFFFu, 0u}) {
    bus.store(kRccApb2Rstr, bits, 4);
    bus.store(kRccApb1Rstr, bits, 4);
  }
  for (std::size_t i = 0; i < registers.size(); ++i) EXPECT_EQ(bus.load(registers[i].first, 4), at_first[i]);
  EXPECT_EQ(board.drive(14).mode, PinMode::input);
  EXPECT_FALSE(bus.unmodelled());
}

TEST(BusTest, TheOtherUsartsSendInTheirTimeAndAreHeardByNobody) {
  using namespace robosim::stm32;
  struct Heard : SerialWatcher {
    void byte_sent(std::uint8_t, SimTime) override { ++bytes; }
    int bytes = 0;
  } heard;
  BoardState board(*find_board("bluepill"));
  board.watch_serial(heard);
  ClockedBoard clocked(board);
  FlashMemory flash;
  Bus bus(clocked, flash, 0);
  Clock& clock = bus.link().clock;
  bus.store(kRccApb2Enr, kIopaEn, 4);
  bus.store(kRccCfgr, kPpre1Half, 4);  // the bus of USART2 and USART3 has half the processor's clock
  for (const auto& [usart, irq] : {std::pair{2, 38}, std::pair{3, 39}}) {
    const Address base = stm32f103c8::kUarts[usart - 1].address;
    const auto at = [&](Address of_usart1) { return base + of_usart1 - kUsart1; };
    bus.store(at(kUsartBrr), 104, 4);
    EXPECT_EQ(bus.load(at(kUsartBrr), 4), 0u) << "the USART has no clock";
    bus.store(kRccApb1Enr, clock_bit(base), 4);
    bus.store(at(kUsartBrr), 104, 4);
    bus.store(at(kUsartCr1), kUe | kTe | kRe | kTcie, 4);
    bus.store(at(kUsartSr), 0, 4);  // clears TC, which is set after a reset
    bus.store(kNvicIcpr + 4, 1u << (irq - 32), 4);
    const Cycle began = clock.now;
    bus.store(at(kUsartDr), 'x', 4);
    EXPECT_EQ(bus.load(at(kUsartSr), 4), kTxe);
    EXPECT_EQ(bus.next_event() - began, 2u * 10 * 104);
    bus.store(kNvicIser + 4, 1u << (irq - 32), 4);
    EXPECT_EQ(bus.link().nvic.wakes(), 0);
    clock.now = bus.next_event();
    bus.update();
    EXPECT_EQ(bus.load(at(kUsartSr), 4), kTxe | kTc);
    EXPECT_EQ(bus.link().nvic.wakes(), kFirstIrq + irq);
    bus.store(at(kUsartSr), 0, 4);
    bus.store(kNvicIcpr + 4, 1u << (irq - 32), 4);
    board.receive_byte('a', clock.time());
    bus.take_inputs();
    EXPECT_EQ(bus.load(at(kUsartSr), 4) & kRxne, 0u);
  }
  EXPECT_EQ(heard.bytes, 0);
  EXPECT_FALSE(bus.unmodelled());
}

TEST(BusTest, BothAdcsConvertTheirOwnChannelsAndShareAnInterrupt) {
  using namespace robosim::stm32;
  struct Volts : PinSource {
    explicit Volts(double volts) : value(volts) {}
    Source output(SimTime, double) override { return value; }
    bool level(SimTime) override { return false; }
    double value;
  } quarter(3.3 / 4), half(3.3 / 2);
  BoardState board(*find_board("bluepill"));
  board.connect(14, quarter);  // channel 0
  board.connect(15, half);
  ClockedBoard clocked(board);
  FlashMemory flash;
  Bus bus(clocked, flash, 0);
  bus.store(kRccApb2Enr, clock_bit(kAdc1) | clock_bit(kAdc2), 4);
  bus.store(kNvicIser, 1u << kIrqAdc, 4);
  const Address second = kAdc2 - kAdc1;
  for (const Address adc : {Address{0}, second}) {
    bus.store(adc + kAdcCr1, 1u << 5, 4);  // EOCIE
    bus.store(adc + kAdcSqr3, adc == 0 ? 0 : 1, 4);
    bus.store(adc + kAdcCr2, kAdOn, 4);
    bus.store(adc + kAdcCr2, kAdOn, 4);
  }
  for (Cycle& now = bus.link().clock.now; bus.next_event() != kNoCycle; bus.update()) now = bus.next_event();
  EXPECT_EQ(bus.load(kAdcDr, 4), 1024u);
  bus.store(kNvicIcpr, 1u << kIrqAdc, 4);
  EXPECT_EQ(bus.link().nvic.wakes(), kFirstIrq + kIrqAdc) << "ADC2 still requests the interrupt";
  EXPECT_EQ(bus.load(second + kAdcDr, 4), 2048u);
  bus.store(kNvicIcpr, 1u << kIrqAdc, 4);
  EXPECT_EQ(bus.link().nvic.wakes(), 0);
  EXPECT_FALSE(bus.unmodelled());
}

}  // namespace robosim::exec::stm32::registers_test
