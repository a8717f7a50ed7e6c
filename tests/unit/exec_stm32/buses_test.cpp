// Tests SPI (RM0008, chapter 25) and I2C (chapter 26), without devices at their pins.
#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::buses_test {

using namespace robosim::stm32;

constexpr std::uint32_t kMaster = 1u << 2 | 1u << 6 | 3u << 8;  // MSTR, SPE, SSM, SSI
constexpr std::uint32_t kRxneFlag = 1, kTxeFlag = 2, kModf = 1u << 5, kOvr = 1u << 6, kBsy = 1u << 7;

class SpiTest : public BusFixture {
 protected:
  std::uint32_t status() { return load(kSpi1 + 8); }
  struct High : PinSource {
    bool level(SimTime) override { return true; }
  } high_;
};

TEST_F(SpiTest, AFrameTakesItsTimeAndBringsTheLevelOfMiso) {
  enable(kIrqSpi1);
  store(kSpi1, kMaster | 2u << 3);  // 8 cycles per bit
  EXPECT_EQ(status(), kTxeFlag);
  store(kSpi1 + 12, 0x55);
  EXPECT_EQ(status(), kTxeFlag | kBsy);
  store(kSpi1 + 12, 0x66);
  EXPECT_EQ(status(), kBsy);
  store(kSpi1 + 4, 1u << 6);  // RXNEIE
  pass(63);
  EXPECT_FALSE(takes(kIrqSpi1));
  pass(1);
  EXPECT_TRUE(takes(kIrqSpi1));
  EXPECT_EQ(status(), kBsy | kTxeFlag | kRxneFlag);
  EXPECT_EQ(load(kSpi1 + 12), 0u);
  board_.connect(12, high_);  // PA6
  pass(64);
  EXPECT_EQ(status(), kTxeFlag | kRxneFlag);
  EXPECT_EQ(load(kSpi1 + 12), 0xFFu);
  store(kSpi1, kMaster | 1u << 11);  // 16 bits, 2 cycles each
  for (int i = 0; i < 2; ++i) {
    store(kSpi1 + 12, 0);
    pass(32);
  }
  EXPECT_EQ(status(), kTxeFlag | kRxneFlag | kOvr) << "the first frame was not read";
  EXPECT_EQ(load(kSpi1 + 12), 0xFFFFu);
  status();
  EXPECT_EQ(status(), kTxeFlag);
}

TEST_F(SpiTest, AMasterThatIsSelectedIsNoneAnyMore) {
  store(kSpi1, kMaster & ~(1u << 8));  // SSI = 0
  EXPECT_EQ(status(), kModf | kTxeFlag);
  EXPECT_EQ(load(kSpi1) & (1u << 2 | 1u << 6), 0u);
}

TEST_F(SpiTest, DmaSendsAndReceives) {
  const Address rx = kDma1 + 8 + 20, tx = kDma1 + 8 + 40;
  board_.connect(12, high_);
  store(rx + 8, kSpi1 + 12);
  store(rx + 12, kRam + 0x80);
  store(rx + 4, 3);
  store(rx, 1 | 1u << 7);
  store(tx + 8, kSpi1 + 12);
  store(tx + 12, kRam + 0x40);
  store(tx + 4, 3);
  store(tx, 1 | 1u << 4 | 1u << 7);
  store(kSpi1 + 4, 3);
  store(kSpi1, kMaster);
  pass(16 * 3);
  EXPECT_EQ(load(kDma1), 0x770u);
  EXPECT_EQ(*bus_.ram().at(kRam + 0x82, 1), 0xFF);
}

class I2cTest : public BusFixture {
 protected:
  void SetUp() override {
    BusFixture::SetUp();
    store(kI2c1 + 4, 8);
    store(kI2c1 + 0x1C, 40);  // 100 kHz
    store(kI2c1, 1);
  }
  std::uint32_t status() { return load(kI2c1 + 0x14); }
  std::uint32_t state() { return load(kI2c1 + 0x18); }
  static constexpr Cycle kBit = 80;
  static constexpr std::uint32_t kStart = 1u << 8, kStop = 1u << 9, kSb = 1, kAf = 1u << 10, kBusyMaster = 3;
};

TEST_F(I2cTest, NobodyAnswersAnAddress) {
  store(kI2c1, 1 | kStart);
  pass(kBit);
  EXPECT_EQ(status(), kSb);
  EXPECT_EQ(state(), kBusyMaster);
  EXPECT_EQ(load(kI2c1), 1u) << "START is done";
  store(kI2c1 + 0x10, 0x78);
  EXPECT_EQ(status(), 0u);
  pass(9 * kBit - 1);
  EXPECT_EQ(status(), 0u);
  pass(1);
  EXPECT_EQ(status(), kAf);
  store(kI2c1 + 0x14, 0);
  EXPECT_EQ(status(), 0u);
  store(kI2c1, 1 | kStart);
  pass(kBit);
  EXPECT_EQ(status(), kSb) << "a repeated start";
  store(kI2c1, 1 | kStop);
  pass(kBit);
  EXPECT_EQ(state(), 0u);
  EXPECT_EQ(load(kI2c1), 1u);
}

TEST_F(I2cTest, ItsEventAndItsErrorInterrupt) {
  enable(kIrqI2c1Event);
  enable(kIrqI2c1Error);
  store(kI2c1 + 4, 8 | 3u << 8);
  store(kI2c1, 1 | kStart);
  pass(kBit);
  EXPECT_TRUE(takes(kIrqI2c1Event));
  store(kI2c1 + 0x10, 0x78);
  EXPECT_FALSE(takes(kIrqI2c1Event));
  pass(9 * kBit);
  EXPECT_TRUE(takes(kIrqI2c1Error));
  store(kI2c1 + 0x14, 0);
  EXPECT_FALSE(takes(kIrqI2c1Error));
}

}  // namespace robosim::exec::stm32::buses_test
