// Tests the analog comparator with voltages, which the programs of tests/conformance cannot set.
#include <gtest/gtest.h>

#include "hal/board/atmega2560.h"
#include "hal/board/atmega32u4.h"
#include "hal/board/attiny85.h"
#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace comparator_test {

constexpr Address kTifr1 = 0x36, kAcsr = 0x50, kTccr1b = 0x81, kIcr1l = 0x86, kIcr1h = 0x87;
constexpr std::uint8_t kByOne = 1;
constexpr int kVector = 23;

class ComparatorTest : public testing::Test, protected IdleChip {
 protected:
  ComparatorTest() {
    positive(1.0);
    negative(2.0);
  }
  void positive(double volts) { bench.pin_voltages[pin('D', 6)] = volts; }
  void negative(double volts) { bench.pin_voltages[pin('D', 7)] = volts; }
  /// Sets both comparator pins to the digital level LOW, and removes their voltages.
  void take_levels() {
    bench.pin_voltages.clear();
    bench.levels[pin('D', 6)] = bench.levels[pin('D', 7)] = false;
  }
  /// Returns the number of cycles between a rising edge of AIN0 and its capture by timer 1.
  int delay_of_rise() {
    const auto since = static_cast<int>(now());
    bench.set_level(pin('D', 6), true);
    run(100);
    return captured() - since;
  }
  int captured() {
    const int low = read(kIcr1l);
    return read(kIcr1h) << 8 | low;
  }
};

TEST_F(ComparatorTest, ComparesTheVoltagesOfItsPins) {
  EXPECT_EQ(read(kAcsr), 0);
  positive(2.1);
  EXPECT_EQ(read(kAcsr), kAco | kAci);
  negative(2.2);
  EXPECT_EQ(read(kAcsr), kAci);
}

TEST_F(ComparatorTest, ComparesWithTheBandgapOf1100mV) {
  write(kAcsr, kAcbg);
  negative(1.05);
  EXPECT_TRUE(read(kAcsr) & kAco);
  negative(1.15);
  EXPECT_FALSE(read(kAcsr) & kAco);
}

TEST_F(ComparatorTest, ComparesWithAnAnalogInputWhileTheConverterIsOff) {
  bench.voltages[3] = 0.5;
  write(reg::kAdcsrb, kAcme);
  write(reg::kAdmux, 0xC3);
  EXPECT_TRUE(read(kAcsr) & kAco);
  write(reg::kAdcsra, 0x80);
  EXPECT_FALSE(read(kAcsr) & kAco) << "compares with AIN1 again";
}

TEST_F(ComparatorTest, LooksByItselfWhileItMayInterrupt) {
  write(kAcsr, kAcie);
  let_interrupts();
  run(100);
  EXPECT_EQ(vector(), 0);
  positive(3.0);
  run(100);
  EXPECT_EQ(vector(), kVector);
}

TEST_F(ComparatorTest, SeesAPulseOfAPinThatNobodyAwaits) {
  take_levels();
  write(kAcsr, 0);
  bench.set_level(pin('D', 6), true);
  bench.set_level(pin('D', 6), false);
  EXPECT_EQ(read(kAcsr), kAci);
}

TEST_F(ComparatorTest, HearsNoPinWhileItIsOff) {
  write(kAcsr, 0);
  EXPECT_TRUE(bench.listens_to[pin('D', 6)]);
  write(kAcsr, kAcd);
  EXPECT_FALSE(bench.listens_to[pin('D', 6)]);
  EXPECT_FALSE(bench.listens_to[pin('D', 7)]);
}

TEST_F(ComparatorTest, IsCapturedByTimer1) {
  write(kTccr1b, kIces | kByOne);
  write(kAcsr, kAcic);
  run(1000);
  EXPECT_EQ(read(kTifr1) & kIcf, 0);
  positive(3.0);
  const auto since = static_cast<int>(now());
  run(200);
  EXPECT_EQ(read(kTifr1) & kIcf, kIcf);
  EXPECT_GT(captured(), since);
  EXPECT_LE(captured(), since + 64 + 3);
}

TEST_F(ComparatorTest, IsCapturedThroughTheNoiseCanceler) {
  take_levels();
  write(kTccr1b, kIcnc | kIces | kByOne);
  write(kAcsr, kAcic);
  run(100);
  bench.set_level(pin('D', 6), true);
  run(2);
  bench.set_level(pin('D', 6), false);
  run(100);
  EXPECT_EQ(read(kTifr1) & kIcf, 0) << "a pulse of less than 4 cycles";
  const int delayed = delay_of_rise();
  write(kTccr1b, kIces | kByOne);
  bench.set_level(pin('D', 6), false);
  run(100);
  EXPECT_EQ(delayed, delay_of_rise() + 4);
}

TEST_F(ComparatorTest, AChangeOfWhatIsCapturedIsAnEdgeIfTheyDiffer) {
  bench.levels[pin('B', 0)] = false;
  write(kTccr1b, kIces | kByOne);
  positive(3.0);
  write(kAcsr, kAcic);
  run(10);
  EXPECT_EQ(read(kTifr1) & kIcf, kIcf);
  write(kTifr1, kIcf);
  write(kAcsr, 0);
  run(10);
  EXPECT_EQ(read(kTifr1) & kIcf, 0) << "a falling edge";
}

/// A chip of any type, whose processor waits in an endless loop.
class OtherChip {
 public:
  explicit OtherChip(const ChipSpec& spec) : bench(spec, kLoop) {}
  void write(Address address, std::uint8_t value) { bench.chip.cpu().store(address, value); }
  bool output(Address acsr) { return bench.chip.cpu().load(acsr) & kAco; }

 private:
  static constexpr std::uint8_t kLoop[] = {0xFF, 0xCF};

 public:
  conformance::Bench bench;
};

TEST(ComparatorOfOthers, ComparesWith16InputsOfAnAtmega2560) {
  OtherChip chip(kAtmega2560);
  chip.bench.pin_voltages[chip.bench.chip.pins().named("PE2")] = 1.0;
  chip.bench.voltages[10] = 3.0;
  chip.write(reg::kAdmux, 2);
  chip.write(reg::kAdcsrb, kAcme);
  EXPECT_TRUE(chip.output(kAcsr));
  chip.write(reg::kAdcsrb, kAcme | 8);
  EXPECT_FALSE(chip.output(kAcsr));
}

TEST(ComparatorOfOthers, ComparesAnAtmega32u4sOnlyPinWithTheBandgap) {
  OtherChip chip(kAtmega32u4);
  auto& volts = chip.bench.pin_voltages[chip.bench.chip.pins().named("PE6")];
  volts = 1.2;
  EXPECT_TRUE(chip.output(kAcsr));
  volts = 1.0;
  EXPECT_FALSE(chip.output(kAcsr));
}

TEST(ComparatorOfOthers, LooksAtTwoBitsOfAnAttiny85sMultiplexer) {
  OtherChip chip(kAttiny85);
  chip.bench.pin_voltages[chip.bench.chip.pins().named("PB0")] = 1.0;
  chip.bench.voltages[1] = 3.0;
  chip.write(kAttiny85.at.adc_control_b, kAcme);
  chip.write(kAttiny85.at.adc_multiplexer, 0x0C);
  EXPECT_TRUE(chip.output(kAttiny85.comparator.address));
  chip.write(kAttiny85.at.adc_multiplexer, 0x0D);
  EXPECT_FALSE(chip.output(kAttiny85.comparator.address));
}

}  // namespace comparator_test
}  // namespace robosim::avr
