// Drives a chain of 74HC595s over three pins of the board. Each register adds eight outputs.
//
// Wiring: DATA to the first register's SER (DS), its QH' (Q7S) to the next register's SER, and so on; CLOCK
// to SRCLK (SHCP) and LATCH to RCLK (STCP) of all registers; OE to ground, SRCLR (MR) to 5 V.
//
// Bit q of byte i is output Qq of register i; register 0 is the first in the chain. set() only stores the
// value. show() sends all bytes, and then all outputs change at once. At power-on the outputs are undefined:
// call begin() early in setup().
//
//   ShiftRegisters out(11, 13, 10, 2);   // data, clock, latch, two registers
//   void setup() { out.begin(); out.set(1, 0x80); out.show(); }
#ifndef LINEKIT_SHIFT_REGISTERS_H
#define LINEKIT_SHIFT_REGISTERS_H

#include <Arduino.h>

class ShiftRegisters {
 public:
  static const uint8_t kMost = 4;

  ShiftRegisters(uint8_t data, uint8_t clock, uint8_t latch, uint8_t count)
      : data_(data), clock_(clock), latch_(latch), count_(count < kMost ? count : kMost) {}

  /// Configures the pins as outputs and sends the stored bytes, which are 0 unless set() has been called.
  void begin();
  void set(uint8_t index, uint8_t bits) {
    if (index < kMost) bits_[index] = bits;
  }
  uint8_t get(uint8_t index) const { return index < kMost ? bits_[index] : 0; }
  /// Sends all bytes, which takes about 0.13 ms per register on an Uno.
  void show();

 private:
  uint8_t data_, clock_, latch_, count_;
  uint8_t bits_[kMost] = {0};
};

#endif
