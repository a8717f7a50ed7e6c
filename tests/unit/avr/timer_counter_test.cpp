// Tests that advancing a counter by many ticks at once equals counting tick by tick. Also tests that frequent
// reads do not change a timer.
#include <gtest/gtest.h>

#include <random>

#include "sim/mcu/avr/timer_counter.h"
#include "tests/support/effort.h"
#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace timer_counter_test {

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  unsigned below(unsigned count) { return static_cast<unsigned>(engine_() % count); }
  /// Returns a small value, a value near the maximum, or any value.
  std::uint16_t value(std::uint16_t max) {
    const unsigned any = below(max + 1u);
    const unsigned values[] = {below(5), max - below(5), any, any};
    return static_cast<std::uint16_t>(values[below(4)] & max);
  }

 private:
  std::mt19937 engine_;
};

TEST(Counter, RunsThroughManyTicksAsOneByOne) {
  Chance chance(1);
  for (int timer = 0; timer < 2; ++timer) {
    const TimerSpec& spec = kAtmega328p.timers[timer];
    const std::uint16_t max = timer == 1 ? 0xFFFF : 0xFF;
    Counter at_once;
    for (int i = 0; i < test::rounds(4000); ++i) {
      switch (chance.below(6)) {
        case 0:
          at_once.count(counting(spec, static_cast<std::uint8_t>(chance.below(4)),
                                 static_cast<std::uint8_t>(chance.below(4) << 3)),
                        max);
          break;
        case 1:
          at_once.set_value(chance.value(max));
          break;
        case 2:
          at_once.set_capture(chance.value(max));
          break;
        default:
          at_once.write_compare(chance.below(2), chance.value(max));
      }
      Counter one_by_one = at_once;
      const Cycle ticks = chance.below(chance.below(10) ? 600 : 70000);
      const auto wanted = static_cast<std::uint8_t>(1 << chance.below(8));
      const Cycle expected = at_once.ticks_to(wanted);
      Cycle found = kNoCycle;
      std::uint8_t hits = 0;
      for (Cycle tick = 1; tick <= ticks; ++tick) {
        const std::uint8_t hit = one_by_one.advance(1);
        if (hit & wanted && found == kNoCycle) found = tick;
        hits |= hit;
      }
      ASSERT_EQ(at_once.advance(ticks), hits) << "step " << i;
      ASSERT_EQ(at_once.value(), one_by_one.value()) << "step " << i;
      ASSERT_EQ(at_once.counts_down(), one_by_one.counts_down()) << "step " << i;
      ASSERT_EQ(at_once.compare(0), one_by_one.compare(0)) << "step " << i;
      if (found != kNoCycle || expected <= ticks) {
        ASSERT_EQ(found, expected) << "step " << i;
      }
    }
  }
}

class WatchedTimers : public testing::TestWithParam<unsigned> {};

/// Returns the timers' registers, the drives of their pins, and the state of the interrupts.
std::vector<unsigned> seen(IdleChip& chip) {
  std::vector<unsigned> values;
  for (const Address address : {0x35, 0x36, 0x37, 0x46, 0x47, 0x48, 0x84, 0x85, 0x86, 0x87, 0x88, 0xB2})
    values.push_back(chip.read(address));
  for (const PinDrive& drive : {chip.bench.drives[chip.pin('D', 6)], chip.bench.drives[chip.pin('D', 5)],
                                chip.bench.drives[chip.pin('B', 1)], chip.bench.drives[chip.pin('B', 3)]})
    values.push_back(static_cast<unsigned>(drive.duty * 1e6) + drive.level);
  values.push_back(static_cast<unsigned>(chip.bench.chip.core().interrupts.state));
  return values;
}

TEST_P(WatchedTimers, CountAsUnwatchedOnes) {
  Chance chance(GetParam());
  IdleChip watched, alone;
  for (IdleChip* chip : {&watched, &alone}) {
    chip->write(0x2A, 0xFF);
    chip->write(0x24, 0xFE);
    chip->write(0x81, 0x40);
    chip->run(10);
  }
  const Address registers[] = {0x35, 0x36, 0x37, 0x44, 0x45, 0x46, 0x47, 0x48, 0x6E, 0x6F,
                               0x70, 0x80, 0x81, 0x84, 0x85, 0x86, 0x87, 0x88, 0x89, 0x8A,
                               0x8B, 0xB0, 0xB1, 0xB2, 0xB3, 0xB4, 0x43, 0x64, 0x2B, 0x82};
  for (int i = 0; i < 300; ++i) {
    const Address address = registers[chance.below(std::size(registers))];
    auto value = static_cast<std::uint8_t>(chance.value(0xFF));
    if (address == 0x64) value &= chance.below(4) ? 0 : 0x68;
    if (address == 0x43 && chance.below(3)) value = 0;
    const bool edge = chance.below(8) == 0, level = chance.below(2);
    const Cycle until = watched.now() + chance.below(chance.below(8) ? 300 : 70000);
    for (IdleChip* chip : {&watched, &alone}) {
      chip->write(address, value);
      if (edge) chip->bench.set_level(chip->pin('B', 0), level);
    }
    while (watched.now() < until) {
      watched.run_to(watched.now() + 1 + chance.below(40));
      for (const Address look : {0x35, 0x36, 0x37, 0x46, 0x88, 0xB2}) watched.read(look);
    }
    alone.run_to(watched.now());
    ASSERT_EQ(alone.now(), watched.now());
    ASSERT_EQ(seen(alone), seen(watched)) << "step " << i << ", register " << address;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, WatchedTimers, testing::Range(1u, 25u));

}  // namespace timer_counter_test
}  // namespace robosim::avr
