// Receives messages bit by bit over three wires from a radio receiver (433 or 315 MHz) and its decoder.
//
//   ENABLE  high during a message      DATA  the current bit      CLOCK  rises in the middle of each bit
//
// ENABLE and CLOCK use interrupts (pins 2 and 3 on an Uno), so no bit is missed, whatever the sketch does. A
// message is complete once ENABLE has fallen. If another message arrives before the sketch has read the
// first, the first is lost. A sketch can have only one receiver.
//
//   ClockedReceiver radio(5, 2, 3);   // data, clock, enable
//   void setup() { radio.begin(); }
//   void loop() {
//     if (radio.available() && radio.bits() == 8) go(radio.value());
//   }
#ifndef LINEKIT_CLOCKED_RECEIVER_H
#define LINEKIT_CLOCKED_RECEIVER_H

#include <Arduino.h>

class ClockedReceiver {
 public:
  ClockedReceiver(uint8_t data, uint8_t clock, uint8_t enable)
      : data_(data), clock_(clock), enable_(enable) {}

  void begin();
  /// Returns whether a message has arrived since the last call. bits() and value() then describe it.
  bool available();
  /// Returns the message's number of bits; 255 also stands for longer messages.
  uint8_t bits() const { return bits_; }
  /// Returns the message's last 16 bits, most significant first.
  uint16_t value() const { return value_; }

 private:
  static void onClock();
  static void onEnable();

  static ClockedReceiver* receiver_;

  uint8_t data_, clock_, enable_;
  uint8_t bits_ = 0;
  uint16_t value_ = 0;
  // Shared with the interrupts.
  volatile uint8_t coming_bits_ = 0, come_bits_ = 0;
  volatile uint16_t coming_ = 0, come_ = 0;
  volatile bool has_come_ = false;
};

#endif
