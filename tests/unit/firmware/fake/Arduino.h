// A fake of the Arduino core: declares the functions that the library in firmware/ uses. Tests set and read
// the clock and the pins of this fake.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define CHANGE 1
#define RISING 3
#define MSBFIRST 1
#define A0 14
#define A1 15
#define A2 16
#define digitalPinToInterrupt(pin) (pin)

namespace fake {

struct Pin {
  std::uint8_t mode = INPUT;
  std::uint8_t level = LOW;       ///< the level that the firmware wrote
  int duty = -1;                  ///< the last analogWrite(); -1 = none since the last digitalWrite()
  int reads = LOW;                ///< result of digitalRead()
  int analog = 0;                 ///< result of analogRead()
  std::uint32_t drains_us = 0;    ///< time for which an input reads HIGH after it was an output
  std::uint32_t released_us = 0;  ///< the time at which the pin became an input
  int rises = 0;                  ///< number of times that the firmware changed the pin from LOW to HIGH
  void (*handler)() = nullptr;    ///< the function passed to attachInterrupt()
  int handler_mode = 0;
};

struct Board {
  Pin pins[32];
  std::vector<std::uint8_t> shifted;  ///< bytes of shiftOut()
  std::uint32_t now_us = 0;
  std::function<void()> on_wait;      ///< called while the firmware waits; a test moves its robot here
  std::uint32_t millis_at_start = 0;  ///< millis() at now_us = 0; millis() wraps at 2^32
};

/// The board that the functions below use. Each test creates a new one.
extern Board board;

}  // namespace fake

void pinMode(std::uint8_t pin, std::uint8_t mode);
void digitalWrite(std::uint8_t pin, std::uint8_t level);
int digitalRead(std::uint8_t pin);
int analogRead(std::uint8_t pin);
void analogWrite(std::uint8_t pin, int duty);
unsigned long millis();
unsigned long micros();
void delay(unsigned long ms);
void delayMicroseconds(unsigned int us);
void shiftOut(std::uint8_t data, std::uint8_t clock, std::uint8_t order, std::uint8_t value);
void attachInterrupt(std::uint8_t pin, void (*handler)(), int mode);
void interrupts();
void noInterrupts();
