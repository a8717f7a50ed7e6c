#include "Arduino.h"

namespace fake {
Board board;
}

using fake::board;

void pinMode(std::uint8_t pin, std::uint8_t mode) {
  if (board.pins[pin].mode == OUTPUT && mode != OUTPUT) board.pins[pin].released_us = board.now_us;
  board.pins[pin].mode = mode;
}

void digitalWrite(std::uint8_t pin, std::uint8_t level) {
  if (level == HIGH && board.pins[pin].level == LOW) ++board.pins[pin].rises;
  board.pins[pin].level = level;
  board.pins[pin].duty = -1;
}

int digitalRead(std::uint8_t pin) {
  board.now_us += 4;
  const fake::Pin& p = board.pins[pin];
  if (p.drains_us > 0) return board.now_us - p.released_us < p.drains_us ? HIGH : LOW;
  return p.reads;
}

int analogRead(std::uint8_t pin) { return board.pins[pin].analog; }

void analogWrite(std::uint8_t pin, int duty) { board.pins[pin].duty = duty; }

unsigned long millis() { return board.millis_at_start + board.now_us / 1000; }

unsigned long micros() { return board.now_us; }

void delay(unsigned long ms) { delayMicroseconds(static_cast<unsigned int>(1000 * ms)); }

void delayMicroseconds(unsigned int us) {
  board.now_us += us;
  if (board.on_wait) board.on_wait();
}

void shiftOut(std::uint8_t, std::uint8_t, std::uint8_t, std::uint8_t value) {
  board.shifted.push_back(value);
}

void attachInterrupt(std::uint8_t pin, void (*handler)(), int mode) {
  board.pins[pin].handler = handler;
  board.pins[pin].handler_mode = mode;
}

void interrupts() {}

void noInterrupts() {}
