// A sketch whose output depends on the board's clock and supply. The tests of several targets run it:
//
//   pin 12   high for 100 ms by delay(), low, then high while ten bytes are sent at 57600 baud
//   prints   F_CPU in MHz, the reading of A7, the time of ten analogRead() and of 1000 digitalRead() in us
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "hal/board/sim_time.h"

namespace robosim::test {

inline const char* const kClockSketch = R"(#ifndef ARDUINO_AVR_PRO
#error "another board"
#endif
void setup() {
  pinMode(12, OUTPUT);
  digitalWrite(12, HIGH);
  delay(100);
  digitalWrite(12, LOW);
  Serial.begin(57600);
  digitalWrite(12, HIGH);
  Serial.print("12345678\r\n");
  Serial.flush();
  digitalWrite(12, LOW);
  Serial.println(F_CPU / 1000000L);
  Serial.println(analogRead(A7));
  Serial.flush();
  unsigned long begin = micros();
  for (byte i = 0; i < 10; ++i) analogRead(A7);
  Serial.println(micros() - begin);
  Serial.flush();
  begin = micros();
  for (int i = 0; i < 1000; ++i) digitalRead(i & 7);
  Serial.println(micros() - begin);
}
void loop() {})";

/// A board on which the tests run the sketch.
struct ClockedBoard {
  const char* name;
  long mhz;
  double supply_volts;
};
inline constexpr ClockedBoard kProMinis[] = {{"promini8", 8, 3.3}, {"promini16", 16, 5.0}};

/// The duration of ten readings, which take fourteen ADC clocks each. The ADC runs at 125 kHz on both boards.
inline constexpr double kTenReads_us = 1120;

/// The measured durations of ten analogRead() and of a thousand digitalRead(), which each target's test
/// checks.
struct ReadTimes {
  double ten_analog_us = 0.0;
  double thousand_digital_us = 0.0;
};

/// Checks the numbers that the sketch printed, and the times at which pin 12 changed. The caller runs the
/// sketch for a second, with half the supply on A7.
inline ReadTimes expect_clock(const ClockedBoard& board, const std::vector<long long>& printed,
                              const std::vector<SimTime>& changes) {
  constexpr double kTenBytes_ns = 1.7e6;  // ten bits each at 58824 baud, the nearest possible rate
  constexpr double kClose_ns = 0.05e6;
  SCOPED_TRACE(board.name);
  EXPECT_EQ(printed.size(), 5u) << ::testing::PrintToString(printed);
  EXPECT_EQ(changes.size(), 5u);
  if (printed.size() != 5 || changes.size() != 5) return {};
  EXPECT_NEAR(static_cast<double>(changes[2] - changes[1]), 100e6, kClose_ns);
  EXPECT_NEAR(static_cast<double>(changes[4] - changes[3]), kTenBytes_ns, kClose_ns);
  EXPECT_EQ(printed[1], board.mhz);
  EXPECT_EQ(printed[2], 512);
  return {static_cast<double>(printed[3]), static_cast<double>(printed[4])};
}

/// Expects that digitalRead() takes twice the time at half the clock.
inline void expect_twice_the_time(const ReadTimes& at_8, const ReadTimes& at_16) {
  EXPECT_NEAR(at_8.thousand_digital_us / at_16.thousand_digital_us, 2.0, 0.01);
}

}  // namespace robosim::test
