// A sketch that shows what of it depends on a board's clock and supply, for every target that runs it:
//
//   pin 12   high for 100 ms by delay(), low, then high while ten bytes leave at 57600 baud
//   prints   F_CPU in MHz, A7, microseconds of ten analogRead(), and of a thousand digitalRead()
#pragma once

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

/// A board that the sketch is for.
struct ClockedBoard {
  const char* name;
  long mhz;
  double supply_volts;
};
inline constexpr ClockedBoard kProMinis[] = {{"promini8", 8, 3.3}, {"promini16", 16, 5.0}};

/// Ten bits each, as nearly as both clocks allow: 58824 baud.
inline constexpr double kTenBytes_ns = 1.7e6;
/// Fourteen clocks of the ADC each: both clocks give it 125 kHz.
inline constexpr double kTenReads_us = 1120;

}  // namespace robosim::test
