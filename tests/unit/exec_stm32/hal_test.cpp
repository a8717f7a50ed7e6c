// Tests every function of hal/stm32 that accesses registers, with the model of the chip. hal/stm32 is
// compiled for this machine. Its loads and stores of registers access the bus of the emulated chip.

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/stm32/bus.h"
#include "tests/unit/exec_stm32/hal_firmware.h"

namespace robosim::exec::stm32::hal_test {

using testing::ElementsAre;

/// Replaces the processor: advances time with every register access, and calls the handlers of pending
/// interrupts.
class Chip {
 public:
  Chip(BoardState& state, FlashMemory& flash) : board(state), bus(board, flash, 0) {}

  void pass(Cycle cycles) {
    Clock& clock = bus.link().clock;
    for (const Cycle end = clock.now + cycles; clock.now < end;) {
      const Cycle input = clock.cycle_at(bus.link().board.next_input());
      clock.now = std::min(end, std::max(std::min(bus.next_event(), input), clock.now + 1));
      settle();
    }
  }
  void settle() {
    bus.update();
    bus.take_inputs();
    while (interrupts_on && !serving) {
      const Exception exception = bus.link().nvic.next(false, 0);
      if (exception == 0) return;
      serving = true;
      bus.link().nvic.enter(exception);
      handler_of(exception)();
      bus.link().nvic.leave(exception);
      serving = false;
      bus.update();
    }
  }
  static void (*handler_of(Exception exception))() {
    using namespace robosim::stm32;
    if (exception == robosim::exec::stm32::kSysTick) return SysTick_Handler;
    switch (exception - kFirstIrq) {
      case kIrqTim1Update:
        return TIM1_UP_IRQHandler;
      case kIrqTim2:
        return TIM2_IRQHandler;
      case kIrqUsart1:
        return USART1_IRQHandler;
      case kIrqExti9_5:
        return EXTI9_5_IRQHandler;
      default:
        return EXTI15_10_IRQHandler;
    }
  }
  void sleep() {
    while (!bus.link().nvic.wakes()) {
      bus.link().clock.now = std::max(bus.next_event(), bus.link().clock.now + 1);
      bus.update();
      bus.take_inputs();
    }
    settle();
  }

  ClockedBoard board;
  Bus bus;
  bool interrupts_on = true, serving = false;
};

Chip* chip = nullptr;
constexpr Cycle kAccess = 4;

}  // namespace robosim::exec::stm32::hal_test

namespace robosim::stm32 {

using robosim::exec::stm32::hal_test::chip;
using robosim::exec::stm32::hal_test::kAccess;

uint32_t load(Address address) {
  chip->pass(kAccess);
  return chip->bus.load(address, 4);
}
void store(Address address, uint32_t value) {
  chip->pass(kAccess);
  chip->bus.store(address, value, 4);
  chip->settle();
}
uint16_t load_half(Address address) { return static_cast<uint16_t>(chip->bus.load(address, 2)); }
void store_half(Address address, uint16_t value) { chip->bus.store(address, value, 2); }
bool disable_interrupts() { return std::exchange(chip->interrupts_on, false); }
void restore_interrupts(bool enabled) {
  if (!enabled) return;
  chip->interrupts_on = true;
  chip->settle();
}
bool takes_interrupts() { return chip->interrupts_on && !chip->serving; }
void wait_for_interrupt() { chip->sleep(); }

}  // namespace robosim::stm32

namespace robosim::exec::stm32::hal_test {

class HalTest : public testing::Test, protected PinWatcher, protected SerialWatcher {
 protected:
  struct Volts : PinSource {
    Source output(SimTime, double) override { return value; }
    bool level(SimTime) override {
      ++asked;
      return value > 1.6;
    }
    double value = 0.0;
    int asked = 0;
  };

  HalTest() {
    chip = chip_.get();
    board_.watch_serial(*this);
    robosim::stm32::start_clocks();
    init();
  }
  ~HalTest() override {
    EXPECT_FALSE(chip_->bus.unmodelled()) << chip_->bus.unmodelled()->what;
    chip = nullptr;
  }

  void pin_changed(Pin, const PinDrive& drive, SimTime t) override {
    levels_.push_back(drive.level);
    times_.push_back(t);
  }
  void byte_sent(std::uint8_t byte, SimTime) override { sent_ += static_cast<char>(byte); }
  SimTime now() const { return chip_->bus.link().clock.time(); }

  BoardState board_{*find_board("bluepill")};
  FlashMemory flash_;
  std::unique_ptr<Chip> chip_ = std::make_unique<Chip>(board_, flash_);
  std::string sent_;
  std::vector<bool> levels_;
  std::vector<SimTime> times_;
};

TEST_F(HalTest, TheClockIs72MegahertzAndMillisecondsPass) {
  EXPECT_EQ(chip_->bus.link().clock.hz(), 72'000'000u);
  const unsigned long start = micros();
  const SimTime began = now();
  delay(5);
  EXPECT_NEAR(static_cast<double>(micros() - start), 5000.0, 3.0);
  EXPECT_NEAR(static_cast<double>(now() - began), 5e6, 3e3);
  delayMicroseconds(40);
  EXPECT_NEAR(static_cast<double>(now() - began), 5.04e6, 5e3);
  EXPECT_EQ(millis(), micros() / 1000);
}

TEST_F(HalTest, AWaitOfMicrosecondsLastsAsLongWithInterruptsOff) {
  for (const unsigned int us : {1u, 15u, 500u, 3000u, 16000u}) {
    for (const bool on : {true, false}) {
      if (!on) robosim::stm32::disable_interrupts();
      const SimTime began = now();
      delayMicroseconds(us);
      EXPECT_NEAR(static_cast<double>(now() - began), 1e3 * us, 2e3) << us << " us, interrupts on: " << on;
      robosim::stm32::restore_interrupts(true);
    }
  }
}

TEST_F(HalTest, AWaitOfMicrosecondsInAHandlerEnds) {
  static SimTime took;
  const auto handler = [] {
    const SimTime began = chip->bus.link().clock.time();
    delayMicroseconds(1500);
    took = chip->bus.link().clock.time() - began;
  };
  took = 0;
  attachInterrupt(digitalPinToInterrupt(2), handler, RISING);
  board_.schedule_edge(2, true, now() + kMicrosecond);
  chip_->pass(72);
  EXPECT_NEAR(static_cast<double>(took), 1.5e6, 2e3);
}

TEST_F(HalTest, MicrosNeverGoesBack) {
  unsigned long last = micros();
  for (int i = 0; i < 3000; ++i) {
    chip_->pass(61);
    const unsigned long next = micros();
    ASSERT_GE(next, last);
    ASSERT_LE(next - last, 4u);
    last = next;
  }
}

TEST_F(HalTest, EveryPinIsSetAndReadUnderItsNumber) {
  for (Pin pin = 0; pin < board_.spec().pin_count; ++pin) {
    pinMode(pin, OUTPUT);
    EXPECT_EQ(board_.drive(pin).mode, PinMode::output) << int{pin};
    digitalWrite(pin, HIGH);
    EXPECT_TRUE(board_.drive(pin).level) << int{pin};
    EXPECT_EQ(digitalRead(pin), HIGH);
    digitalWrite(pin, LOW);
    EXPECT_FALSE(board_.drive(pin).level) << int{pin};
    pinMode(pin, INPUT_PULLUP);
    EXPECT_EQ(board_.drive(pin).mode, PinMode::input_pullup) << int{pin};
    EXPECT_EQ(digitalRead(pin), HIGH);
    pinMode(pin, INPUT);
    EXPECT_EQ(board_.drive(pin).mode, PinMode::input) << int{pin};
  }
}

TEST_F(HalTest, DigitalReadAsksOnePinOnly) {
  Volts one, neighbour;
  board_.connect(7, one);        // PB14
  board_.connect(8, neighbour);  // PB15
  one.value = 3.3;
  EXPECT_EQ(digitalRead(7), HIGH);
  EXPECT_EQ(one.asked, 1);
  EXPECT_EQ(neighbour.asked, 0);
}

TEST_F(HalTest, AnalogReadHasTenBitsOfTheSupplyOnEveryInput) {
  Volts source;
  for (Pin pin = 0; pin < board_.spec().pin_count; ++pin) {
    if (board_.spec().pins[pin].analog_channel < 0) continue;
    source.value = 1.65;
    board_.connect(pin, source);
    EXPECT_EQ(analogRead(pin), 512) << int{pin};
    source.value = 3.3;
    EXPECT_EQ(analogRead(pin), 1023);
    source.value = 0.0;
    EXPECT_EQ(analogRead(pin), 0);
  }
  EXPECT_EQ(analogRead(2), 0) << "no analog input";
}

TEST_F(HalTest, AnalogReadTakesAnotherResolution) {
  Volts source;
  source.value = 1.65;
  board_.connect(14, source);
  for (const auto& [bits, code] : {std::pair{12, 2048}, {16, 32768}, {8, 128}, {1, 1}, {10, 512}}) {
    analogReadResolution(bits);
    EXPECT_EQ(analogRead(14), code) << bits;
  }
  source.value = 1.651;
  analogReadResolution(12);
  EXPECT_EQ(analogRead(14), 2049) << "the converter has twelve bits";
  for (const int bits : {0, 17, -3}) analogReadResolution(bits);
  EXPECT_EQ(analogRead(14), 2049) << "invalid resolutions are ignored";
  analogReadResolution(10);
}

/// Slightly more than a PWM period, which is 282 * 255 cycles. A new duty takes effect at the next period.
constexpr Cycle kPwmPeriod = 73'440;

TEST_F(HalTest, AnalogWriteTakesAnotherResolution) {
  analogWriteResolution(12);
  analogWrite(5, 51 << 4);
  chip_->pass(kPwmPeriod);
  EXPECT_DOUBLE_EQ(board_.drive(5).duty, 0.2);
  analogWrite(5, 4095);
  chip_->pass(kPwmPeriod);
  EXPECT_DOUBLE_EQ(board_.drive(5).duty, 1.0);
  analogWriteResolution(8);
}

TEST_F(HalTest, AnalogWriteIsADutyOnEveryPinThatHasPwmAndDigitalWriteEndsIt) {
  for (Pin pin = 0; pin < board_.spec().pin_count; ++pin) {
    if (!board_.spec().pins[pin].pwm) continue;
    analogWrite(pin, 51);
    chip_->pass(kPwmPeriod);
    EXPECT_TRUE(board_.drive(pin).pwm) << int{pin};
    EXPECT_DOUBLE_EQ(board_.drive(pin).duty, 0.2) << int{pin};
    analogWrite(pin, 255);
    chip_->pass(kPwmPeriod);
    EXPECT_DOUBLE_EQ(board_.drive(pin).duty, 1.0);
    analogWrite(pin, 0);
    chip_->pass(kPwmPeriod);
    EXPECT_DOUBLE_EQ(board_.drive(pin).duty, 0.0);
    digitalWrite(pin, HIGH);
    EXPECT_FALSE(board_.drive(pin).pwm);
    EXPECT_TRUE(board_.drive(pin).level);
  }
  analogWrite(7, 200);
  EXPECT_TRUE(board_.drive(7).level) << "no PWM: HIGH from 128 on";
}

TEST_F(HalTest, ToneTogglesItsPinAsLongAsItLasts) {
  pinMode(11, OUTPUT);
  board_.watch(11, *this);
  tone(11, 1000, 3);
  chip_->pass(72'000 * 6);
  ASSERT_EQ(times_.size(), 6u);
  EXPECT_NEAR(static_cast<double>(times_[1] - times_[0]), 500e3, 1e3);
  EXPECT_FALSE(levels_.back());
  tone(11, 440);
  chip_->pass(72'000 * 20);
  EXPECT_GT(times_.size(), 20u);
  noTone(11);
  EXPECT_FALSE(board_.drive(11).level);
}

int rises = 0, falls = 0;

TEST_F(HalTest, InterruptsComeAtTheEdgesThatWereAskedFor) {
  rises = falls = 0;
  attachInterrupt(
      digitalPinToInterrupt(2), [] { ++rises; }, RISING);
  attachInterrupt(
      digitalPinToInterrupt(3), [] { ++falls; }, FALLING);
  EXPECT_TRUE(board_.wants_edges(2));
  const SimTime t = now();
  for (const Pin pin : {2, 3})
    for (int i = 0; i < 4; ++i) board_.schedule_edge(pin, i % 2 == 0, t + (i + 1) * 100 * kMicrosecond);
  chip_->pass(72 * 1000);
  EXPECT_EQ(rises, 2);
  EXPECT_EQ(falls, 2);
  detachInterrupt(digitalPinToInterrupt(2));
  EXPECT_FALSE(board_.wants_edges(2));
}

TEST_F(HalTest, SerialSendsMoreThanItsBufferAndReceives) {
  serial_begin(115200);
  std::string text;
  for (int i = 0; i < 10; ++i) text += "0123456789";
  serial_write(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  serial_flush();
  EXPECT_EQ(sent_, text);
  board_.receive_byte('a', now());
  board_.receive_byte('b', now());
  chip_->pass(72 * 300);
  EXPECT_EQ(serial_available(), 2);
  EXPECT_EQ(serial_peek(), 'a');
  EXPECT_EQ(serial_read(), 'a');
  EXPECT_EQ(serial_read(), 'b');
  EXPECT_EQ(serial_read(), -1);
}

TEST_F(HalTest, ABytesTimeIsThatOfTheBaudRate) {
  serial_begin(9600);
  const SimTime began = now();
  serial_write(reinterpret_cast<const uint8_t*>("x"), 1);
  serial_flush();
  EXPECT_NEAR(static_cast<double>(now() - began), 10.0 / 9600 * 1e9, 5e3);
}

TEST_F(HalTest, PulseInMeasuresAPulse) {
  struct Pulse : PinSource {
    bool level(SimTime t) override { return t >= begin && t < begin + 700 * kMicrosecond; }
    SimTime begin = 0;
  } pulse;
  pulse.begin = now() + 300 * kMicrosecond;
  board_.connect(12, pulse);
  EXPECT_NEAR(static_cast<double>(pulseIn(12, HIGH, 1'000'000)), 700.0, 3.0);
  EXPECT_EQ(pulseIn(12, HIGH, 1000), 0u) << "no second pulse";
}

TEST_F(HalTest, TheEepromKeepsWhatIsWrittenThroughItsChangesOfBanks) {
  EXPECT_EQ(robosim_eeprom_read(7), 0xFF);
  std::vector<std::uint8_t> expected(1024, 0xFF);
  for (unsigned i = 0; i < 700; ++i) {
    const auto address = static_cast<std::uint16_t>(i * 37 % 1024);
    const auto value = static_cast<std::uint8_t>(i * 11);
    robosim_eeprom_write(address, value);
    expected[address] = value;
  }
  for (std::uint16_t i = 0; i < 1024; ++i) ASSERT_EQ(robosim_eeprom_read(i), expected[i]) << i;
  // Creates another chip with the same flash.
  chip_ = std::make_unique<Chip>(board_, flash_);
  chip = chip_.get();
  for (std::uint16_t i = 0; i < 1024; i = static_cast<std::uint16_t>(i + 51))
    EXPECT_EQ(robosim_eeprom_read(i), expected[i]) << i;
}

TEST_F(HalTest, AWriteThatPowerOffInterruptsLeavesTheValueBefore) {
  robosim_eeprom_write(5, 50);
  robosim_eeprom_write(5, 51);
  // Erases the second halfword of the record, as if power had failed before the address was written there.
  for (std::uint8_t* half = flash_.data(); half < flash_.data() + robosim::stm32::kFlashBytes; half += 4)
    if (half[0] == 51 && half[1] == 0xA5) half[2] = half[3] = 0xFF;
  EXPECT_EQ(robosim_eeprom_read(5), 50);
  robosim_eeprom_write(5, 52);
  EXPECT_EQ(robosim_eeprom_read(5), 52);
}

TEST_F(HalTest, ShiftOutAndShiftInTakeTheOrderOfBits) {
  pinMode(11, OUTPUT);
  pinMode(13, OUTPUT);
  board_.watch(11, *this);
  shiftOut(11, 13, MSBFIRST, 0xA0);
  EXPECT_THAT(levels_, ElementsAre(true, false, true, false));
  Volts high;
  high.value = 3.3;
  board_.connect(12, high);
  pinMode(12, INPUT);
  EXPECT_EQ(shiftIn(12, 13, LSBFIRST), 0xFF);
}

}  // namespace robosim::exec::stm32::hal_test
