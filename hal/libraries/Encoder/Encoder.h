// Reads quadrature encoders, with the API of Paul Stoffregen's library. A period has four counts. The count
// rises if the signal of the second pin leads.
//
// If both pins have interrupts, interrupt handlers count the edges. Otherwise read() polls the levels, as in
// the genuine library.
#pragma once

#include <Arduino.h>

class Encoder {
 public:
  Encoder(uint8_t pin1, uint8_t pin2) : pin1_(pin1), pin2_(pin2) {
    pinMode(pin1, INPUT_PULLUP);
    pinMode(pin2, INPUT_PULLUP);
    delayMicroseconds(2000);  // as in the genuine library: lets input filters settle
    levels_ = levels();
    const bool first = follow(pin1), second = follow(pin2);
    followed_ = first && second;
  }

  int32_t read() {
    const uint8_t interrupts = SREG;
    cli();
    if (!followed_) update();
    const int32_t count = count_;
    SREG = interrupts;
    return count;
  }
  int32_t readAndReset() {
    const int32_t count = read();
    write(0);
    return count;
  }
  void write(int32_t count) {
    const uint8_t interrupts = SREG;
    cli();
    count_ = count;
    SREG = interrupts;
  }

 private:
  static const int kHandlers = 8;

  static uint8_t level(uint8_t pin) {
    const uint8_t port = digitalPinToPort(pin);
    if (port == NOT_A_PORT) return digitalRead(pin);
    return *portInputRegister(port) & digitalPinToBitMask(pin) ? 1 : 0;
  }
  uint8_t levels() const { return static_cast<uint8_t>(level(pin1_) | level(pin2_) << 1); }

  void update() {
    // Changes of the count. Index: previous levels (bits 0, 1) and present levels (bits 2, 3). If both levels
    // have changed, an edge was missed. The count changes by two, as if the second pin had changed first.
    static const int8_t counts[16] = {0, 1, -1, 2, -1, 0, -2, 1, 1, -2, 0, -1, 2, -1, 1, 0};
    const uint8_t now = levels();
    count_ += counts[levels_ | now << 2];
    levels_ = now;
  }

  static Encoder*& at(int number) {
    static Encoder* encoders[kHandlers];
    return encoders[number];
  }
  template <int number>
  static void handle() {
    at(number)->update();
  }
  bool follow(uint8_t pin) {
    static void (*const handlers[kHandlers])() = {handle<0>, handle<1>, handle<2>, handle<3>,
                                                  handle<4>, handle<5>, handle<6>, handle<7>};
    const int number = digitalPinToInterrupt(pin);
    if (number < 0 || number >= kHandlers) return false;
    at(number) = this;
    attachInterrupt(static_cast<uint8_t>(number), handlers[number], CHANGE);
    return true;
  }

  uint8_t pin1_, pin2_;
  uint8_t levels_;
  bool followed_;
  volatile int32_t count_ = 0;
};
