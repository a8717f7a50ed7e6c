// Tests the USART: received and sent frames, the duration of a frame, and the drives of its pins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace usart_test {

using testing::ElementsAre;
using testing::Pair;

constexpr Address kStatus = 0xC0, kControl = 0xC1, kFormat = 0xC2, kDivider = 0xC4, kData = 0xC6;
constexpr int kReceivedVector = 18;

class UsartTest : public testing::Test, protected IdleChip {
 protected:
  void receive(std::uint16_t data) { bench.chip.receive(0, data, now()); }
};

TEST_F(UsartTest, ReceivesInOrder) {
  write(kControl, kRxen);
  receive(0x41);
  receive(0x42);
  EXPECT_EQ(read(kStatus), kRxc | kUdre);
  EXPECT_EQ(read(kData), 0x41);
  EXPECT_EQ(read(kData), 0x42);
  EXPECT_EQ(read(kStatus), kUdre);
}

TEST_F(UsartTest, HoldsThreeFramesAndLosesTheThirdToAFourth) {
  write(kControl, kRxen);
  for (const int byte : {1, 2, 3}) receive(static_cast<std::uint16_t>(byte));
  EXPECT_EQ(read(kStatus), kRxc | kUdre);
  receive(4);
  EXPECT_EQ(read(kStatus), kRxc | kUdre | kDor);
  EXPECT_EQ(read(kData), 1);
  EXPECT_EQ(read(kStatus), kRxc | kUdre);
  EXPECT_EQ(read(kData), 2);
  EXPECT_EQ(read(kData), 4);
  EXPECT_EQ(read(kStatus), kUdre);
}

TEST_F(UsartTest, SwitchingItsReceiverOffEmptiesIt) {
  write(kControl, kRxen);
  receive(1);
  write(kControl, 0);
  receive(2);
  EXPECT_EQ(read(kStatus), kUdre);
  write(kControl, kRxen);
  EXPECT_EQ(read(kStatus), kUdre);
}

TEST_F(UsartTest, RequestsItsInterruptUntilItIsRead) {
  write(kControl, kRxen | kRxcie);
  receive(1);
  let_interrupts();
  run(10);
  EXPECT_EQ(vector(), kReceivedVector);
  EXPECT_TRUE(bench.chip.core().interrupts.is_requested(kReceivedVector));
  read(kData);
  EXPECT_FALSE(bench.chip.core().interrupts.is_requested(kReceivedVector));
}

TEST_F(UsartTest, ServesAFrameThatCameBeforeItsEnable) {
  let_interrupts();
  write(kControl, kRxen);
  receive(1);
  run(10);
  EXPECT_EQ(vector(), 0);
  write(kControl, kRxen | kRxcie);
  run(10);
  EXPECT_EQ(vector(), kReceivedVector);
}

TEST_F(UsartTest, HasTheNinthBitInItsControlRegister) {
  write(kControl, kRxen | 0x04);
  write(kFormat, kUcsz);
  receive(0x1A5);
  receive(0x05A);
  EXPECT_EQ(read(kControl), kRxen | 0x04 | 0x02);
  EXPECT_EQ(read(kData), 0xA5);
  EXPECT_EQ(read(kControl), kRxen | 0x04);
}

TEST_F(UsartTest, SendsTheNinthBitOfItsControlRegister) {
  write(kControl, kTxen | 0x04 | 0x01);
  write(kData, 0x12);
  write(kControl, kTxen | 0x04);
  write(kData, 0x34);
  run(400);
  EXPECT_THAT(bench.sent_bytes, ElementsAre(Pair(0, 0x112), Pair(176, 0x034)));
}

TEST_F(UsartTest, SendsTheLastByteThatWasWrittenBeforeItsTransmitterWasOn) {
  write(kData, 1);
  write(kData, 2);
  EXPECT_EQ(read(kStatus), kUdre);
  run(500);
  EXPECT_TRUE(bench.sent_bytes.empty());
  const Cycle on = now();
  write(kControl, kTxen);
  run(500);
  EXPECT_THAT(bench.sent_bytes, ElementsAre(Pair(on, 2)));
}

TEST_F(UsartTest, TellsWhatAFrameTakes) {
  write(kDivider, 103);
  EXPECT_TRUE(bench.frames.empty());
  write(kControl, kRxen);
  write(kFormat, kUsbs | kUcsz);
  write(kControl, 0);
  EXPECT_THAT(bench.frames, ElementsAre(Pair(0, 16640), Pair(0, 18304), Pair(0, 0)));
}

TEST_F(UsartTest, IsDeafWhileItsClockStands) {
  write(kControl, kRxen);
  write(reg::kPrr, 0x02);
  receive(1);
  write(reg::kPrr, 0);
  EXPECT_EQ(read(kStatus), kUdre);
  EXPECT_THAT(bench.frames, ElementsAre(Pair(0, 160), Pair(0, 0), Pair(0, 160)));
}

TEST_F(UsartTest, OwnsItsPinUntilEverythingHasLeft) {
  const int txd = pin('D', 1);
  EXPECT_EQ(bench.drives[txd].mode, PinMode::input);
  write(kControl, kTxen);
  EXPECT_EQ(bench.drives[txd].mode, PinMode::output);
  EXPECT_TRUE(bench.drives[txd].level);
  write(kData, 1);
  write(kControl, 0);
  run(150);
  EXPECT_EQ(bench.drives[txd].mode, PinMode::output);
  run(20);
  EXPECT_EQ(bench.drives[txd].mode, PinMode::input);
}

TEST_F(UsartTest, ItsInputIsAnInputWhateverThePortSays) {
  const int rxd = pin('D', 0);
  write(0x2A, 0x01);  // DDRD
  EXPECT_EQ(bench.drives[rxd].mode, PinMode::output);
  write(kControl, kRxen);
  EXPECT_EQ(bench.drives[rxd].mode, PinMode::input);
  write(0x2B, 0x01);  // PORTD
  EXPECT_EQ(bench.drives[rxd].mode, PinMode::input_pullup);
  write(kControl, 0);
  EXPECT_EQ(bench.drives[rxd].mode, PinMode::output);
}

TEST_F(UsartTest, IsAsAfterPowerOnBehindAReset) {
  write(kControl, kRxen | kTxen);
  write(kData, 1);
  receive(1);
  bench.chip.reset(0x02);
  EXPECT_EQ(read(kStatus), kUdre);
  EXPECT_EQ(read(kFormat), 0x06);
  EXPECT_EQ(bench.frames.back().second, 0u);
  EXPECT_EQ(bench.drives[pin('D', 1)].mode, PinMode::input);
}

}  // namespace usart_test
}  // namespace robosim::avr
