// Tests snapshots and resets of a complete chip.
#include <gtest/gtest.h>

#include "hal/board/attiny85.h"
#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace chip_test {

class ChipTest : public testing::Test, protected IdleChip {
 protected:
  /// Starts all peripherals at the same time.
  void begin_everything() {
    write(reg::kAdcsra, 0xEF);  // free running, with its interrupt
    write(0xC1, 0x58);          // USART: both directions, with TXCIE
    write(0xC6, 0x55);
    write(0xC6, 0xAA);
    write(reg::kEedr, 0x12);
    write(reg::kEecr, 0x04);
    write(reg::kEecr, 0x02);
    write(reg::kWdtcsr, 0x40);
    write(0x24, 0x2C);  // DDRB: SS, MOSI, SCK
    write(0x4C, 0xD3);  // SPI
    write(0x4E, 0x99);
    write(0xBC, 0xA5);  // TWI: START
    write(reg::kEicra, 0x05);
    write(reg::kPcmsk2, 0x0C);
    write(reg::kPcicr, 0x04);
    for (const Address control :
         {0x44, 0x80, 0xB0}) {  // timers: PWM, a prescaler of 64 or 32, all interrupts
      write(control, 0x81);
      write(control + 1, 0x43);
    }
    for (const Address enables : {0x6E, 0x6F, 0x70}) write(enables, 0x27);
    for (const Address compare : {0x47, 0x88, 0xB3}) write(compare, 0x40);
    bench.chip.receive(0, 0x77, now());
  }
  std::vector<std::uint8_t> registers() {
    std::vector<std::uint8_t> values;
    for (Address address = reg::kFirstIo; address < 0x100; ++address) values.push_back(read(address));
    return values;
  }
};

TEST_F(ChipTest, ARestoredOneRunsOnAsBefore) {
  begin_everything();
  run(100);
  const auto snapshot = bench.chip.save();
  const auto go_on = [&] {
    bench.samples.clear();
    bench.sent_bytes.clear();
    let_interrupts();
    bench.set_level(pin('D', 2), true);
    run(300000);
    return registers();
  };
  const auto once = go_on();
  const Cycle end = now();
  const auto samples = bench.samples;
  const auto sent = bench.sent_bytes;
  ASSERT_FALSE(samples.empty());
  ASSERT_FALSE(sent.empty());
  bench.set_level(pin('D', 2), false);
  bench.chip.restore(snapshot);
  EXPECT_EQ(go_on(), once);
  EXPECT_EQ(now(), end);
  EXPECT_EQ(bench.samples, samples);
  EXPECT_EQ(bench.sent_bytes, sent);
}

TEST_F(ChipTest, AResetLeavesItAsAfterPowerOn) {
  run(10);
  const auto fresh = registers();
  begin_everything();
  run(60000);
  bench.chip.reset(0x02);
  auto again = registers();
  EXPECT_EQ(again[reg::kMcusr - reg::kFirstIo], 0x03);
  again[reg::kMcusr - reg::kFirstIo] = fresh[reg::kMcusr - reg::kFirstIo];
  EXPECT_EQ(again, fresh);
  EXPECT_EQ(bench.chip.core().interrupts.state, 0u);
  EXPECT_EQ(bench.chip.core().events.next(), kNoCycle);
}

TEST_F(ChipTest, AResetDoesNotEndAWriteOfTheEeprom) {
  write(reg::kEedr, 0x12);
  write(reg::kEecr, 0x04);
  write(reg::kEecr, 0x02);
  bench.chip.reset(0x02);
  run(54000);
  EXPECT_EQ(read(reg::kEecr), 0x02);
  run(1000);
  EXPECT_EQ(read(reg::kEecr), 0x00);
}

TEST_F(ChipTest, AnIdleOneHasNothingToDo) {
  run(1000);
  EXPECT_EQ(bench.chip.core().events.next(), kNoCycle);
}

TEST(AnAttiny85, HasNoMultiplierAndNoLongJumps) {
  constexpr std::uint16_t kMul = 0x9C01, kJmp = 0x940C, kCall = 0x940E, kMovw = 0x0112;
  const auto stop_at = [](std::uint16_t word) {
    const std::uint8_t flash[] = {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8), 0,
                                  0};
    Cpu cpu(kAttiny85, flash, static_cast<Address>(ram_end(kAttiny85) - 1));
    return cpu.run(1);
  };
  for (const std::uint16_t word : {kMul, kJmp, kCall}) EXPECT_EQ(stop_at(word), Cpu::Stop::illegal);
  EXPECT_EQ(stop_at(kMovw), Cpu::Stop::reached);
}

}  // namespace chip_test
}  // namespace robosim::avr
