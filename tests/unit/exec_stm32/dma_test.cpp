// Tests DMA1 (RM0008, chapter 13) alone, with the ADC (chapter 11), and with the USARTs (chapter 27).
#include <string>

#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::dma_test {

using namespace robosim::stm32;

constexpr std::uint32_t kEn = 1u << 0, kTcie = 1u << 1, kHtie = 1u << 2, kOut = 1u << 4, kCirc = 1u << 5,
                        kPinc = 1u << 6, kMinc = 1u << 7, kP16 = 1u << 8, kM16 = 1u << 10, kM32 = 2u << 10,
                        kMemory = 1u << 14;
constexpr Address kTable = kRam + 0x100;

Irq irq_of_channel(int channel) { return static_cast<Irq>(kIrqDma1Channel1 + channel - 1); }

class DmaTest : public BusFixture, protected SerialWatcher {
 protected:
  void byte_sent(std::uint8_t byte, SimTime) override { sent_ += static_cast<char>(byte); }
  void begin(int channel, Address peripheral, Address memory, std::uint32_t items, std::uint32_t control) {
    const Address at = kDma1 + 8 + 20 * static_cast<Address>(channel - 1);
    store(at, 0);
    store(at + 8, peripheral);
    store(at + 12, memory);
    store(at + 4, items);
    store(at, control | kEn);
  }
  std::uint32_t left(int channel) { return load(kDma1 + 12 + 20 * static_cast<Address>(channel - 1)); }
  std::uint32_t flags(int channel) { return load(kDma1) >> (4 * (channel - 1)) & 15; }
  std::uint8_t* ram(Address address) { return bus_.ram().at(address, 1); }
  std::uint16_t half(Address address) {
    return static_cast<std::uint16_t>(*ram(address) | *ram(address + 1) << 8);
  }

  std::string sent_;
};

TEST_F(DmaTest, CopiesMemoryInItsTimeAndTellsOfTheHalf) {
  for (int i = 0; i < 8; ++i) ram(kTable)[i] = static_cast<std::uint8_t>(i + 1);
  enable(irq_of_channel(3));
  begin(3, kTable, kTable + 0x40, 4, kMemory | kPinc | kMinc | kP16 | kM32 | kTcie | kHtie);
  pass(9);
  EXPECT_EQ(flags(3), 0u);
  pass(1);
  EXPECT_EQ(flags(3), 0b101u);
  EXPECT_EQ(left(3), 2u);
  store(kDma1 + 4, 4u << 8);
  EXPECT_EQ(flags(3), 0u);
  EXPECT_TRUE(takes(irq_of_channel(3)));
  pass(10);
  EXPECT_EQ(flags(3), 0b011u);
  EXPECT_EQ(left(3), 0u);
  // If the target items are wider, DMA fills their upper halves with zeros.
  for (Address i = 0; i < 4; ++i) {
    EXPECT_EQ(half(kTable + 0x40 + 4 * i), half(kTable + 2 * i));
    EXPECT_EQ(half(kTable + 0x42 + 4 * i), 0u);
  }
  store(kDma1 + 4, 1u << 8);
  EXPECT_EQ(flags(3), 0u);
}

TEST_F(DmaTest, AnAddressWhereNothingIsEndsTheTransferWithAnError) {
  begin(1, 0x60000000, kTable, 4, kMemory | kPinc | kMinc);
  pass(100);
  EXPECT_EQ(flags(1), 0b1001u);
  EXPECT_EQ(load(kDma1 + 8) & kEn, 0u);
}

TEST_F(DmaTest, AUsartSendsABufferAndReceivesIntoOneThatGoesRound) {
  board_.watch_serial(*this);
  store(kUsartBrr, 69);
  store(kUsartCr1, kUe | kTe | kRe | kIdleie);
  store(kUsartCr3, kDmaT | kDmaR);
  const std::string text = "Robosim";
  std::copy(text.begin(), text.end(), ram(kTable));
  enable(irq_of_channel(4));
  enable(kIrqUsart1);
  begin(5, kUsartDr, kTable + 0x40, 4, kMinc | kCirc);
  begin(4, kUsartDr, kTable, 7, kMinc | kOut | kTcie);
  EXPECT_EQ(left(4), 5u) << "one byte is being sent, and one waits";
  pass(690 * 5 - 1);
  EXPECT_FALSE(takes(irq_of_channel(4)));
  pass(1);
  EXPECT_EQ(flags(4), 0b111u);
  store(kDma1 + 4, 0xF000);
  EXPECT_TRUE(takes(irq_of_channel(4)));
  EXPECT_EQ(load(kUsartSr) & kTc, 0u);
  pass(690 * 2);
  EXPECT_EQ(load(kUsartSr) & kTc, kTc);
  EXPECT_EQ(sent_, text);
  for (const char byte : std::string("abcdef"))
    board_.receive_byte(static_cast<std::uint8_t>(byte), bus_.link().clock.time());
  pass(690 * 7);
  EXPECT_FALSE(takes(kIrqUsart1));
  pass(690);
  EXPECT_TRUE(takes(kIrqUsart1)) << "the line is idle";
  EXPECT_EQ(std::string(ram(kTable + 0x40), ram(kTable + 0x44)), "efcd");
  EXPECT_EQ(left(5), 2u);
  EXPECT_EQ(flags(5), 0b111u);
}

struct Level : PinSource {
  explicit Level(double of_supply) : volts_(3.3 * of_supply + 1e-5) {}
  Source output(SimTime, double) override { return volts_; }
  bool level(SimTime) override { return false; }
  double volts_;
};

class AdcTest : public DmaTest {
 protected:
  void SetUp() override {
    DmaTest::SetUp();
    board_.connect(14, quarter_);  // channel 0
    board_.connect(15, half_);
    board_.connect(16, most_);
    enable(kIrqAdc);
  }
  static constexpr std::uint32_t kScan = 1u << 8, kEocie = 1u << 5, kJeocie = 1u << 7, kCont = 1u << 1,
                                 kDma = 1u << 8, kTsVrefE = 1u << 23, kJswStart = 7u << 12 | 1u << 15;
  static constexpr Cycle kConversion = 14 * 2;  // in cycles, with the shortest sampling time
  static constexpr Address kJdr1 = kAdc1 + 0x3C, kJsqr = kAdc1 + 0x38, kJofr1 = kAdc1 + 0x14;
  Level quarter_{0.25}, half_{0.5}, most_{0.75};
};

TEST_F(AdcTest, ScansItsChannelsRoundAndRoundIntoATable) {
  store(kAdcSqr1, 2u << 20);
  store(kAdcSqr3, 0 | 1u << 5 | 2u << 10);
  store(kAdcCr1, kScan | kEocie);
  enable(irq_of_channel(1));
  begin(1, kAdcDr, kTable, 6, kMinc | kCirc | kP16 | kM16 | kHtie | kTcie);
  store(kAdcCr2, kAdOn | kCont | kDma | kExtSelSw | kExtTrig);
  store(kAdcCr2, kAdOn | kCont | kDma | kExtSelSw | kExtTrig | kSwStart);
  pass(3 * kConversion - 1);
  EXPECT_EQ(left(1), 4u);
  EXPECT_FALSE(takes(irq_of_channel(1)));
  pass(1);
  EXPECT_EQ(flags(1), 0b101u);
  store(kDma1 + 4, 15);
  EXPECT_TRUE(takes(irq_of_channel(1)));
  pass(3 * kConversion);
  EXPECT_EQ(flags(1), 0b011u);
  for (const Address round : {0u, 6u}) {
    EXPECT_EQ(half(kTable + round), 1024u);
    EXPECT_EQ(half(kTable + round + 2), 2048u);
    EXPECT_EQ(half(kTable + round + 4), 3072u);
  }
  board_.connect(14, most_);
  pass(3 * kConversion);
  EXPECT_EQ(half(kTable), 3072u);
  store(kAdcCr2, 0);
  pass(100);
  const std::uint32_t stands = left(1);
  pass(1000);
  EXPECT_EQ(left(1), stands);
}

TEST_F(AdcTest, TheInjectedGroupInterruptsTheRegularOne) {
  store(kAdcSmpr1 + 4, 7);  // channel 0: 239.5 cycles
  store(kAdcSqr3, 0);
  store(kJsqr, 1u << 20 | 1u << 10 | 2u << 15);  // two channels: 1 and 2
  store(kJofr1, 48);
  store(kJofr1 + 4, 3073);
  store(kAdcCr1, kScan | kEocie | kJeocie);
  store(kAdcCr2, kAdOn | kJswStart);
  store(kAdcCr2, kAdOn | kJswStart);  // starts the regular group
  pass(200);
  store(kAdcCr2, kAdOn | kJswStart | 1u << 21);
  pass(2 * kConversion);
  EXPECT_EQ(load(kAdcSr), 1u << 2 | 1u << 3 | kStrt);
  EXPECT_EQ(load(kJdr1), 2000u);
  EXPECT_EQ(load(kJdr1 + 4), 0xFFFFu) << "the measurement is less than its offset";
  store(kAdcSr, 0);
  EXPECT_TRUE(takes(kIrqAdc));
  pass(252 * 2 - 1);
  EXPECT_EQ(load(kAdcSr), 0u);
  pass(1);
  EXPECT_EQ(load(kAdcSr), kEoc);
  EXPECT_EQ(load(kAdcDr), 1024u);
}

TEST_F(AdcTest, MeasuresTheChipsTemperatureAndItsReference) {
  store(kAdcCr2, kAdOn | kTsVrefE);
  for (const auto& [channel, code] : {std::pair{16u, 1774u}, {17u, 1489u}}) {
    store(kAdcSqr3, channel);
    store(kAdcCr2, kAdOn | kTsVrefE);
    pass(kConversion);
    EXPECT_EQ(load(kAdcDr), code);
  }
}

TEST_F(AdcTest, ItsWatchdogInterruptsOutsideOfTheLimits) {
  store(kAdc1 + 0x24, 2048);
  store(kAdc1 + 0x28, 2000);
  store(kAdcCr1, 1u << 23 | 1u << 6);  // AWDEN, AWDIE
  store(kAdcCr2, kAdOn);
  for (const std::uint32_t channel : {1u, 2u}) {
    store(kAdcSqr3, channel);
    store(kAdcCr2, kAdOn);
    pass(kConversion);
    EXPECT_EQ(load(kAdcSr) & 1, channel == 2u);
  }
  EXPECT_EQ(bus_.link().nvic.wakes(), kFirstIrq + kIrqAdc);
}

TEST_F(AdcTest, AnExternalLineStartsIt) {
  store(kAfioExticr1 + 8, 1u << 12);  // EXTI11 is PB11
  store(kExtiImr, 1u << 11);
  store(kAdcSqr3, 1);
  store(kAdcCr2, kAdOn | 6u << 17 | kExtTrig);
  pass(100);
  EXPECT_EQ(load(kAdcSr), 0u);
  store(kExtiSwier, 1u << 11);
  pass(kConversion);
  EXPECT_EQ(load(kAdcSr), kEoc | kStrt);
  EXPECT_EQ(load(kAdcDr), 2048u);
}

}  // namespace robosim::exec::stm32::dma_test
