// Tests forecasts of the values that firmware will read from a register. The values read later must equal the
// forecast.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace read_forecast_test {

constexpr Address kTifr0 = 0x35, kTifr1 = 0x36, kTifr2 = 0x37, kTcnt0 = 0x46, kTcnt2 = 0xB2;

class OutlookTest : public testing::Test, protected IdleChip {
 protected:
  /// Skips to `cycle` without another access, and reads the register there. Then restores the state that the
  /// chip had before the call. Returns the value.
  std::uint8_t read_at(Address address, Cycle cycle) {
    const auto before = bench.chip.save();
    bench.chip.cpu().skip_to(cycle);
    const std::uint8_t value = read(address);
    bench.chip.restore(before);
    return value;
  }
  ReadForecast forecast(Address address) { return bench.chip.cpu().forecast(address, 0xFF); }
};

TEST_F(OutlookTest, OfTimersHolds) {
  std::mt19937 engine(3);
  const auto below = [&](unsigned count) { return static_cast<unsigned>(engine() % count); };
  int counted = 0, known = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    // Sets random modes, prescalers, compare values and counters, and sometimes clears flags. Interrupts are
    // off, so that the processor stays in its waiting loop.
    write(0x44, static_cast<std::uint8_t>(below(4)));
    write(0x45, static_cast<std::uint8_t>(below(6) | (below(4) == 0) << 3));
    write(0x80, static_cast<std::uint8_t>(below(4)));
    write(0x81, static_cast<std::uint8_t>(below(6) | below(4) << 3));
    write(0xB0, static_cast<std::uint8_t>(below(4)));
    write(0xB1, static_cast<std::uint8_t>(below(8) | (below(4) == 0) << 3));
    for (const Address compare : {0x47, 0x48, 0xB3, 0xB4, 0x88, 0x8A})
      write(compare, static_cast<std::uint8_t>(below(256)));
    for (const Address count : {kTcnt0, kTcnt2, Address{0x84}})
      if (below(2)) write(count, static_cast<std::uint8_t>(below(256)));
    for (const Address flags : {kTifr0, kTifr1, kTifr2})
      if (below(2)) write(flags, 0xFF);
    run(1 + below(below(2) ? 20 : 3000));
    for (const Address address : {kTcnt0, kTcnt2, kTifr0, kTifr1, kTifr2}) {
      const ReadForecast promised = forecast(address);
      if (promised.until <= now()) continue;
      ++known;
      counted += promised.counts();
      const Cycle end = std::min(promised.until, now() + 70'000) - 1;
      for (const Cycle at :
           {now(), now() + 1, now() + below(static_cast<unsigned>(end - now()) + 1), end - 1, end}) {
        if (at < now() || at > end) continue;
        ASSERT_EQ(promised.value_at(at), read_at(address, at))
            << "of " << address << " at " << at << ", asked at " << now() << ", trial " << trial;
      }
      if (!promised.counts() || promised.step >= end) continue;
      const auto ticks = static_cast<unsigned>((end - promised.step) / promised.period);
      const auto aim = static_cast<int>(promised.value + 1 + below(ticks + 1));
      ASSERT_EQ(read_at(address, promised.reaches(aim)), aim);
      ASSERT_EQ(read_at(address, promised.reaches(aim) - 1), aim - 1);
    }
  }
  EXPECT_GT(known, 5000);
  EXPECT_GT(counted, 1000);
}

TEST_F(OutlookTest, IsNoneOfWhatReadingChanges) {
  EXPECT_EQ(forecast(0xC6).until, 0u);  // UDR0
  EXPECT_EQ(forecast(0x78).until, 0u);  // ADCL
}

TEST_F(OutlookTest, OfTheControlOfTheEepromIsNoneWhileItIsUnlocked) {
  constexpr Address kEecr = 0x3F;
  run(6);
  EXPECT_EQ(forecast(kEecr).until, kNoCycle);
  write(kEecr, 4);
  EXPECT_EQ(forecast(kEecr).until, 0u);
  run(6);
  EXPECT_EQ(forecast(kEecr).until, kNoCycle);
  write(kEecr, 4);
  write(kEecr, 2);
  run(6);
  EXPECT_EQ(forecast(kEecr).value, 2);
}

}  // namespace read_forecast_test
}  // namespace robosim::avr
