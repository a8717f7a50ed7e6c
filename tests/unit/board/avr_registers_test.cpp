// Tests the ATmega328P's registers against the tables of its data sheet (DS40002061B).
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "hal/board/atmega328p.h"
#include "hal/board/avr_adc.h"
#include "hal/board/avr_timer.h"

namespace robosim::avr {
namespace avr_registers_test {

using atmega328p::kTimers;
using Kind = Counting::Kind;
using Top = Counting::Top;

constexpr const AdcSpec& kAdc = kAtmega328p.adc;
constexpr std::int64_t kClock_hz = 16'000'000;

/// How a timer counts in a mode. `top` is the counter's TOP for OCRnA = 100 and ICR1 = 5000.
struct Mode {
  int number;  ///< value of the bits WGM
  Kind kind;
  bool dual_slope;
  std::int64_t top;
};

void expect_modes(int timer, const std::vector<Mode>& modes) {
  for (const Mode& mode : modes) {
    const auto a = static_cast<std::uint8_t>(mode.number & 3);
    const auto b = static_cast<std::uint8_t>(timer == 1 ? (mode.number & 0xC) << 1 : (mode.number & 4) << 1);
    const Counting how = counting(kTimers[timer], a, b);
    EXPECT_EQ(how.kind, mode.kind) << "timer " << timer << ", mode " << mode.number;
    EXPECT_EQ(how.dual_slope, mode.dual_slope) << "timer " << timer << ", mode " << mode.number;
    EXPECT_EQ(top_of(how, 100, 5000), mode.top) << "timer " << timer << ", mode " << mode.number;
  }
}

TEST(AvrTimer, Timers0And2CountAsTables15_8And18_8Say) {
  for (const int timer : {0, 2})
    expect_modes(timer, {{0, Kind::normal, false, 0xFF},
                         {1, Kind::pwm, true, 0xFF},
                         {2, Kind::clear_on_match, false, 100},
                         {3, Kind::pwm, false, 0xFF},
                         {5, Kind::pwm, true, 100},
                         {7, Kind::pwm, false, 100}});
}

TEST(AvrTimer, Timer1CountsAsTable16_4Says) {
  expect_modes(1, {{0, Kind::normal, false, 0xFFFF},
                   {1, Kind::pwm, true, 0xFF},
                   {2, Kind::pwm, true, 0x1FF},
                   {3, Kind::pwm, true, 0x3FF},
                   {4, Kind::clear_on_match, false, 100},
                   {5, Kind::pwm, false, 0xFF},
                   {6, Kind::pwm, false, 0x1FF},
                   {7, Kind::pwm, false, 0x3FF},
                   {8, Kind::pwm, true, 5000},
                   {9, Kind::pwm, true, 100},
                   {10, Kind::pwm, true, 5000},
                   {11, Kind::pwm, true, 100},
                   {12, Kind::clear_on_match, false, 5000},
                   {14, Kind::pwm, false, 5000},
                   {15, Kind::pwm, false, 100}});
}

TEST(AvrTimer, ClocksAreDividedAsTables15_9And16_5And18_9Say) {
  const std::int32_t of_01[] = {0, 1, 8, 64, 256, 1024}, of_2[] = {0, 1, 8, 32, 64, 128, 256, 1024};
  for (std::uint8_t select = 0; select < 6; ++select) {
    EXPECT_EQ(prescaler(kTimers[0], 0xF8 | select), of_01[select]);
    EXPECT_EQ(prescaler(kTimers[1], 0xF8 | select), of_01[select]);
  }
  for (std::uint8_t select = 0; select < 8; ++select) EXPECT_EQ(prescaler(kTimers[2], select), of_2[select]);
  EXPECT_EQ(prescaler(kTimers[0], 6), 0) << "an external clock";
  EXPECT_EQ(prescaler(kTimers[1], 7), 0) << "an external clock";
}

TEST(AvrTimer, APeriodIsTopAndOneTickOrTwiceTop) {
  EXPECT_EQ(period_of(counting(kTimers[0], 3, 0), 0xFF), 256);
  EXPECT_EQ(period_of(counting(kTimers[0], 1, 0), 0xFF), 510);
  EXPECT_EQ(period_of(counting(kTimers[1], 0, 0x10), 0), 1) << "no timer counts to a TOP of 0";
}

PinDrive driven(int timer, std::uint8_t a, std::uint8_t b, std::uint16_t compare, int channel,
                std::uint16_t compare_a = 0) {
  const Counting how = counting(kTimers[timer], a, b);
  return timer_drive(how, prescaler(kTimers[timer], b), top_of(how, channel == 0 ? compare : compare_a, 0),
                     compare, connection(a, channel), kClock_hz);
}

TEST(AvrTimer, FastPwmIsHighForOneTickMoreThanItsRegisterSays) {
  EXPECT_EQ(driven(0, 0x83, 3, 63, 0).duty, 64.0 / 256);
  EXPECT_EQ(driven(0, 0x23, 3, 0, 1).duty, 1.0 / 256) << "a narrow spike (15.7.3)";
  EXPECT_EQ(driven(0, 0xC3, 3, 63, 0).duty, 1.0 - 64.0 / 256) << "inverted";
  EXPECT_TRUE(driven(0, 0x83, 3, 63, 0).pwm);
}

TEST(AvrTimer, PhaseCorrectPwmReachesBothEnds) {
  EXPECT_EQ(driven(1, 0x81, 3, 0, 0).duty, 0.0);
  EXPECT_EQ(driven(1, 0x81, 3, 51, 0).duty, 51.0 / 255);
  EXPECT_EQ(driven(1, 0x81, 3, 255, 0).duty, 1.0);
  EXPECT_EQ(driven(1, 0x81, 3, 400, 0).duty, 1.0) << "beyond TOP";
}

TEST(AvrTimer, AToggledPinHasTheFrequencyOfTheDataSheetsFormula) {
  // f = clock / (2 N (1 + OCRnA)) with the prescaler N, 15.7.2
  const PinDrive tone = driven(2, 0x42, 4, 141, 0);
  EXPECT_EQ(tone.tone_hz, 16'000'000u / (2 * 64 * 142));
  EXPECT_EQ(tone.duty, 0.5);
  // In mode 5 (phase-correct PWM up to OCRA), a compare match occurs once in 2 * TOP ticks, at TOP.
  EXPECT_EQ(driven(2, 0x41, 0x0C, 100, 0).tone_hz, 16'000'000u / (2 * 64 * 200));
}

TEST(AvrTimer, InPwmModesOnlyChannelAIsToggledAndOnlyWhereTopCanBeSet) {
  EXPECT_TRUE(drives_pin(counting(kTimers[0], 0, 0), 1, 1));
  EXPECT_FALSE(drives_pin(counting(kTimers[0], 3, 0), 1, 0));
  EXPECT_TRUE(drives_pin(counting(kTimers[0], 3, 8), 1, 0));
  EXPECT_FALSE(drives_pin(counting(kTimers[0], 3, 8), 1, 1));
  EXPECT_TRUE(drives_pin(counting(kTimers[1], 2, 0x18), 1, 0)) << "mode 14";
  EXPECT_FALSE(drives_pin(counting(kTimers[1], 2, 0x10), 1, 0)) << "mode 10";
  EXPECT_TRUE(drives_pin(counting(kTimers[0], 3, 0), 2, 1));
  EXPECT_FALSE(drives_pin(counting(kTimers[0], 3, 0), 0, 1));
}

TEST(AvrTimer, WhatStandsStillOrComparesWithoutPwmHoldsItsPin) {
  EXPECT_FALSE(driven(0, 0x83, 0, 63, 0).pwm) << "no clock";
  EXPECT_FALSE(driven(0, 0x80, 3, 63, 0).level) << "cleared at the match";
  EXPECT_TRUE(driven(0, 0xC0, 3, 63, 0).level) << "set at the match";
}

TEST(AvrTimer, AChannelIsConnectedByItsTwoBits) {
  EXPECT_EQ(connection(0xB1, 0), 2);
  EXPECT_EQ(connection(0xB1, 1), 3);
  EXPECT_EQ(connection(0x03, 0), 0);
}

TEST(AvrAdc, ClocksAreDividedAsTable24_5Says) {
  const int of[] = {2, 2, 4, 8, 16, 32, 64, 128};
  for (std::uint8_t select = 0; select < 8; ++select) EXPECT_EQ(adc_prescaler(0xF8 | select), of[select]);
}

TEST(AvrAdc, AConversionTakesWhatTable24_1Says) {
  EXPECT_EQ(adc_half_clocks_to_sample(false), 3);
  EXPECT_EQ(adc_clocks(false), 13);
  EXPECT_EQ(adc_half_clocks_to_sample(true), 27);
  EXPECT_EQ(adc_clocks(true), 25);
}

TEST(AvrAdc, ReferencesAreThoseOfTable24_3) {
  EXPECT_EQ(adc_reference_volts(kAdc, 0x00, 5.0), 5.0) << "AREF, which is not connected";
  EXPECT_EQ(adc_reference_volts(kAdc, 0x40, 3.3), 3.3) << "AVCC";
  EXPECT_EQ(adc_reference_volts(kAdc, 0xC7, 5.0), 1.1);
}

TEST(AvrAdc, ACodeIsTheShareOfTheReferenceRoundedDown) {
  EXPECT_EQ(adc_code(2.5, 5.0), 512);
  EXPECT_EQ(adc_code(2.499, 5.0), 511);
  EXPECT_EQ(adc_code(5.0, 5.0), 1023);
  EXPECT_EQ(adc_code(-0.1, 5.0), 0);
  EXPECT_EQ(adc_data(0x20, 0x3FF), 0xFFC0) << "left adjusted";
  EXPECT_EQ(adc_data(0x00, 0x3FF), 0x03FF);
}

/// An ADC whose channel N has a voltage of 1.4 V + N * 0.1 V.
struct Adc {
  uint16_t sample(uint8_t multiplexer) {
    const auto source = [&](int channel) {
      asked = channel;
      return Source(1.4 + 0.1 * channel, ohms);
    };
    const auto report = [&](int) { errors.push_back(capacitor.error); };
    return adc_sample(
        kAdc, multiplexer, 0, supply, [] { return 14e-6; }, capacitor, source, report);
  }

  double supply = 5.0, ohms = 0.0;
  AdcCapacitor capacitor;
  std::optional<int> asked;
  std::vector<double> errors;
};

TEST(AvrAdc, ChannelsAreThoseOfTable24_4) {
  Adc adc;
  EXPECT_EQ(adc.sample(0x40 | 3), adc_code(1.7, 5.0));
  EXPECT_EQ(adc.asked, 3);
  adc.asked.reset();
  EXPECT_EQ(adc.sample(0x40 | 14), adc_code(1.1, 5.0)) << "the bandgap";
  EXPECT_EQ(adc.sample(0x40 | 15), 0) << "ground";
  EXPECT_FALSE(adc.asked);
}

TEST(AvrAdc, TheSupplyIsAReferenceThatSinksAndTheBandgapIsNot) {
  Adc adc;
  adc.supply = 4.0;
  EXPECT_EQ(adc.sample(0x40 | 14), adc_code(1.1, 4.0));
  EXPECT_EQ(adc.sample(0x40 | 3), adc_code(1.7, 4.0));
  EXPECT_EQ(adc.sample(0xC0 | 14), 1023);
  EXPECT_EQ(adc.sample(0xC0 | 0), 1023);
}

// 1 MOhm and the ADC's 10 kOhm charge 14 pF with a time constant of 14.14 us.
TEST(AvrAdc, ASlowSourceLeavesAPartOfTheOldVoltage) {
  Adc adc;
  adc.sample(0x40 | 0);
  EXPECT_TRUE(adc.errors.empty()) << "a source without resistance leaves no error";
  adc.ohms = 1e6;
  const double rest = adc_decay(14.0 / 14.14), volts = 1.9 - 0.5 * rest;
  EXPECT_EQ(adc.sample(0x40 | 5), adc_code(volts, 5.0));
  EXPECT_NEAR(adc.capacitor.volts, volts, 1e-9);
  adc.ohms = 0.0;
  adc.sample(0x40 | 1);
  adc.sample(0x40 | 2);
  ASSERT_EQ(adc.errors.size(), 2u) << "the error, and the next sample";
  EXPECT_NEAR(adc.errors[0], -0.5 * rest, 1e-9);
  EXPECT_EQ(adc.errors[1], 0.0);
}

}  // namespace avr_registers_test
}  // namespace robosim::avr
