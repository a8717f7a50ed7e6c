// Tests what a program on the chip can neither observe nor cause: timers' duty cycles as seen by the robot,
// scheduled events, and external edges.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace timer_test {

constexpr Address kDdrb = 0x24, kDdrd = 0x2A, kPortd = 0x2B, kTifr1 = 0x36;
constexpr Address kTccr0a = 0x44, kTccr0b = 0x45, kTcnt0 = 0x46, kOcr0a = 0x47, kTimsk0 = 0x6E,
                  kTimsk1 = 0x6F;
constexpr Address kTccr1a = 0x80, kTccr1b = 0x81, kTcnt1l = 0x84, kIcr1l = 0x86;
constexpr Address kTccr2a = 0xB0, kTccr2b = 0xB1, kOcr2a = 0xB3;
constexpr std::uint8_t kPd6 = 1 << 6, kPb3 = 1 << 3;

class TimerTest : public testing::Test, protected IdleChip {
 protected:
  PinDrive drive(char port, int bit) { return bench.drives[pin(port, bit)]; }
  /// Runs for `cycles`. Returns the number of scheduled events in this time.
  int events(Cycle cycles) {
    const Cycle end = now() + cycles;
    for (int count = 0;; ++count) {
      const Cycle next = bench.chip.core().events.next();
      run_to(std::min(next, end));
      if (next > end) return count;
    }
  }
};

TEST_F(TimerTest, TellsADutyThatChangesWithTheBufferedRegister) {
  write(kDdrd, kPd6);
  write(kTccr0b, 3);
  write(kTccr0a, kComa1 | kWgm1 | kWgm0);
  EXPECT_TRUE(drive('D', 6).pwm);
  EXPECT_EQ(drive('D', 6).duty, 1.0 / 256);
  run(64 * 100);
  write(kOcr0a, 127);
  EXPECT_EQ(drive('D', 6).duty, 1.0 / 256) << "the new value takes effect at BOTTOM";
  run(64 * 256);
  EXPECT_EQ(drive('D', 6).duty, 0.5);
}

TEST_F(TimerTest, GivesThePinBackToThePort) {
  write(kDdrd, kPd6);
  write(kTccr0b, 3);
  write(kTccr0a, kComa1 | kWgm1 | kWgm0);
  write(kPortd, kPd6);
  write(kTccr0a, kWgm1 | kWgm0);
  EXPECT_FALSE(drive('D', 6).pwm);
  EXPECT_TRUE(drive('D', 6).level);
  EXPECT_EQ(drive('D', 6).duty, 1.0);
}

TEST_F(TimerTest, HoldsThePinsLevelWhenItsClockStops) {
  write(kDdrd, kPd6);
  write(kOcr0a, 100);
  write(kTccr0a, kComa1 | kWgm1 | kWgm0);
  for (const int count : {50, 150}) {
    write(kTccr0b, 1);
    write(kTcnt0, static_cast<std::uint8_t>(count));
    write(kTccr0b, 0);
    EXPECT_FALSE(drive('D', 6).pwm);
    EXPECT_EQ(drive('D', 6).level, count <= 100);
  }
}

TEST_F(TimerTest, TellsATogglingPinAsATone) {
  write(kDdrb, kPb3);
  write(kOcr2a, 141);
  write(kTccr2a, kComa0 | kWgm1);
  write(kTccr2b, 4);
  EXPECT_EQ(drive('B', 3).tone_hz, 16'000'000u / (2 * 64 * 142));
  EXPECT_EQ(drive('B', 3).duty, 0.5);
  write(reg::kClkpr, 0x80);
  write(reg::kClkpr, 0x01);
  EXPECT_EQ(drive('B', 3).tone_hz, 8'000'000u / (2 * 64 * 142));
}

TEST_F(TimerTest, TellsTheLevelsOfAPinThatIsToggledTooSlowlyForATone) {
  write(kDdrb, 0x02);  // PB1, OC1A
  write(0x89, 15624 >> 8);
  write(0x88, 15624 & 0xFF);
  write(kTccr1a, kComa0);
  write(kTccr1b, kWgm2 | kCs2 | kCs0);  // clear on match each second, prescaler 1024
  run(100);
  for (const bool level : {false, true, false, true}) {
    EXPECT_FALSE(drive('B', 1).pwm);
    EXPECT_EQ(drive('B', 1).level, level);
    EXPECT_EQ(events(16'000'000), 1);
  }
}

// A counter above TOP counts up to MAX, and can match OCR1A before it reaches MAX (data sheet, 16.9.2).
TEST_F(TimerTest, TogglesAboveTop) {
  constexpr Address kOcr1a = 0x88;
  write(kDdrb, 1 << 1);
  write(kOcr1a + 1, 1000 >> 8);
  write(kOcr1a, 1000 & 0xFF);
  write(kIcr1l + 1, 0);
  write(kIcr1l, 100);
  write(kTcnt1l + 1, 500 >> 8);
  write(kTcnt1l, 500 & 0xFF);
  write(kTccr1a, kComa0);
  write(kTccr1b, kWgm3 | kWgm2 | kCs0);
  run(490);
  EXPECT_FALSE(drive('B', 1).level);
  run(20);
  EXPECT_TRUE(drive('B', 1).level);
  run(200'000);
  EXPECT_TRUE(drive('B', 1).level) << "below TOP, the counter never reaches 1000 again";
}

TEST_F(TimerTest, CostsAnEventAnOverflowWhenOnlyThatInterruptIsOn) {
  write(kTccr0a, 3);
  write(kTccr0b, 3);
  write(kTimsk0, 1);
  run(100);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(events(16384), 1);
    write(reg::kTifr0, 1);
  }
}

TEST_F(TimerTest, CostsNothingWithoutInterrupts) {
  write(kTccr0a, 3);
  write(kTccr0b, 3);
  write(kTccr1a, 1);
  write(kTccr1b, 3);
  write(kTccr2a, 1);
  write(kTccr2b, 4);
  EXPECT_EQ(events(1'000'000), 0);
}

TEST_F(TimerTest, KnowsItsCountAfterALongTime) {
  run(10);
  write(kOcr0a, 9);
  write(kTccr0a, 2);
  write(kTccr0b, 1);
  write(kTcnt0, 0);
  const Cycle written = now();
  bench.chip.cpu().skip_to(16'000'000'000);
  EXPECT_EQ(read(kTcnt0), (now() - written - 1) % 10);
}

TEST_F(TimerTest, StandsStillInDeepSleep) {
  write(kTccr0b, 1);
  write(kTimsk0, 1);
  write(reg::kSmcr, 0x05);  // power-down
  let_interrupts();
  run(20);
  fall_asleep();
  run(100'000);
  EXPECT_TRUE(bench.chip.is_asleep());
  EXPECT_EQ(bench.chip.core().events.next(), kNoCycle);
}

TEST_F(TimerTest, WantsEdgesOfItsPinsOnlyWhileItCountsOrCapturesThem) {
  const int clock = pin('D', 5), capture = pin('B', 0);
  write(kTccr1b, 3);
  EXPECT_FALSE(bench.listens_to[clock]);
  EXPECT_FALSE(bench.listens_to[capture]);
  write(kTccr1b, 7);
  EXPECT_TRUE(bench.listens_to[clock]);
  write(kTccr1b, kIces | kCs0);
  EXPECT_FALSE(bench.listens_to[clock]);
  EXPECT_TRUE(bench.listens_to[capture]);
  write(kTccr1b, kIces | kWgm3 | kWgm2 | kCs0);
  EXPECT_FALSE(bench.listens_to[capture]) << "ICR1 holds TOP, so it captures nothing";
}

TEST_F(TimerTest, CountsAndCapturesEdgesFromOutside) {
  bench.set_level(pin('D', 5), false);
  bench.set_level(pin('B', 0), false);
  run(10);
  write(kTccr1b, kIces | kCs);
  write(kTimsk1, kIcf);
  for (int i = 0; i < 5; ++i) {
    bench.set_level(pin('D', 5), true);
    run(10);
    bench.set_level(pin('D', 5), false);
    run(10);
  }
  EXPECT_EQ(read(kTcnt1l), 5);
  EXPECT_EQ(read(kTifr1) & 0x20, 0);
  bench.set_level(pin('B', 0), true);
  run(10);
  EXPECT_EQ(read(kTifr1) & 0x20, 0x20);
  EXPECT_EQ(read(kIcr1l), 5);
}

// Repeats one interrupt, and expects each repetition at its exact cycle.
TEST_F(TimerTest, InterruptsToTheCycleForEver) {
  struct Way {
    std::uint8_t mode, enables;
    int vector, period;
  };
  for (const Way way : {Way{0, 1, 16, 64 * 256}, Way{3, 1, 16, 64 * 256}, Way{2, 2, 14, 64 * 100}}) {
    SCOPED_TRACE(static_cast<int>(way.mode));
    IdleChip chip;
    chip.write(kOcr0a, 99);
    chip.write(kTccr0a, way.mode);
    chip.write(kTccr0b, 3);
    chip.write(kTimsk0, way.enables);
    const auto serve = [&](Cycle until) {
      chip.bench.chip.cpu().set_pc(0);
      chip.bench.chip.cpu().set_sp(0x8FF);
      chip.let_interrupts();
      chip.run_to(until);
    };
    const Cycle period = static_cast<Cycle>(way.period);
    Cycle due = period;
    for (int time = 0; time < 12; ++time, due += period) {
      serve(due - 3);
      EXPECT_EQ(chip.vector(), 0) << "not sooner";
      chip.run_to(due + 8);
      EXPECT_EQ(chip.vector(), way.vector) << time;
      EXPECT_EQ(chip.read(kTcnt0), 0);
      chip.run_to(due + way.period / 2 + 1);
      EXPECT_EQ(chip.read(kTcnt0), way.period / 128);
      EXPECT_EQ(chip.read(reg::kTifr0) & way.enables, 0);
      if (time == 8) {  // interrupts stay disabled, so some are missed
        chip.run_to(due + 5 * period + period / 2);
        EXPECT_EQ(chip.read(reg::kTifr0) & way.enables, way.enables);
        serve(chip.now() + 8);
        EXPECT_EQ(chip.vector(), way.vector) << "the flag stayed set";
        EXPECT_EQ(chip.read(reg::kTifr0) & way.enables, 0);
        due += 5 * period;
      }
    }
  }
}

TEST_F(TimerTest, StartsConversionsByAFlag) {
  write(kOcr0a, 99);
  write(kTccr0a, 2);
  write(reg::kAdcsrb, 3);     // timer 0's compare A
  write(reg::kAdcsra, 0xA4);  // enabled, started by a trigger, prescaler 16
  write(kTccr0b, 1);
  run(1000);
  EXPECT_EQ(bench.samples.size(), 1u) << "the flag stays set";
  write(reg::kTifr0, 2);
  run(700);
  EXPECT_EQ(bench.samples.size(), 2u);
}

}  // namespace timer_test
}  // namespace robosim::avr
