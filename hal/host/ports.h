// Ports B, C and D (datasheet, chapter 14), and which Arduino pin is which of their bits on an Uno or Nano
// (variants/standard/pins_arduino.h of the Arduino core). A Blue Pill has more pins: they make two ports
// more, which no register shows.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/board/board_spec.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host {

enum Port : uint8_t { kPortB, kPortC, kPortD, kPort20, kPort28, kPorts };

constexpr Pin kPortPins = 20;  ///< 0 to 19 are bits of registers
constexpr Pin kMostPins = 32;

struct PortBits {
  Pin first;  ///< bit 0
  int count;
};
constexpr PortBits kPortBits[kPorts] = {{8, 6}, {14, 6}, {0, 8}, {20, 8}, {28, 4}};

/// Of a pin below kMostPins.
inline Port port_of(Pin pin) {
  if (pin < kPortPins) return pin < 8 ? kPortD : pin < 14 ? kPortB : kPortC;
  return pin < 28 ? kPort20 : kPort28;
}
inline uint8_t mask_of(Pin pin) { return static_cast<uint8_t>(1 << (pin - kPortBits[port_of(pin)].first)); }

/// Whether the board has this pin, and not as an analog input only, as A6 and A7 of a Nano are.
inline bool is_digital(Pin pin) {
  if (pin < kPortPins) return true;
  const BoardSpec& spec = board->spec();
  return pin < kMostPins && pin < spec.pin_count && spec.pins[pin].digital;
}

/// The timer channel that can drive a pin.
struct TimerPin {
  int8_t timer;    ///< -1 = none
  int8_t channel;  ///< 0 = A, 1 = B
};
inline TimerPin timer_of(Pin pin) {
  switch (pin) {
    case 3:
      return {2, 1};
    case 5:
      return {0, 1};
    case 6:
      return {0, 0};
    case 9:
      return {1, 0};
    case 10:
      return {1, 1};
    case 11:
      return {2, 0};
    default:
      return {-1, 0};
  }
}

struct PortRegisters {
  uint8_t direction = 0;  ///< DDRx
  uint8_t output = 0;     ///< PORTx
};
extern PortRegisters ports[kPorts];

/// Writes registers; what changes on the pins is told to the board.
void set_direction(Port port, uint8_t value);
void set_output(Port port, uint8_t value);
/// PINx: what the pins read.
uint8_t read_port(Port port);

/// Tells the board if the way `pin` is driven has changed.
void refresh_pin(Pin pin);
void refresh_timer_pins(int timer);
/// `pin` carries a square wave by tone(); 0 = none.
void set_tone(Pin pin, uint32_t hz);
/// At a reset.
void reset_ports();

}  // namespace host
}  // namespace robosim
