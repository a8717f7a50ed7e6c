// Models the frame format and the receive buffer of an AVR's USART (ATmega328P, data sheet DS40002061B,
// chapter 20), for the target host and for the emulated chip.
//
//   frame     (start + 5..9 data + parity + 1..2 stop) bits of (U2X ? 8 : 16) (UBRR + 1) cycles (table 20-1)
//             synchronous (UMSEL 1): bits of 2 (UBRR + 1) cycles
//   receive   RxD ─► shift register ─► buffer of two ─► UDR    RXC: the buffer contains a frame
//
// A third received frame waits in the shift register. A fourth frame replaces the third, and sets DOR until
// UDR is read.
#pragma once

#include "hal/board/avr_registers.h"

namespace robosim {
namespace avr {

constexpr uint8_t kUcsrcAtReset = kUcsz;

/// Return the number of data bits (table 20-7), and the duration of a frame in cycles, for the registers
/// UCSRnA (`status`), UCSRnB (`control`), UCSRnC (`format`) and UBRRn (`divider`).
constexpr int usart_data_bits(uint8_t control, uint8_t format) {
  return control & kUcsz2 && (format & kUcsz) == kUcsz ? 9 : 5 + ((format & kUcsz) >> 1);
}
constexpr int64_t usart_frame(uint8_t status, uint8_t control, uint8_t format, uint16_t divider) {
  return int64_t{1 + usart_data_bits(control, format) + (format & kUpm1 ? 1 : 0) + (format & kUsbs ? 2 : 1)} *
         ((format & kUmsel) == kUmsel0 ? 2
          : status & kU2x              ? 8
                                       : 16) *
         (divider + 1);
}

/// The receive buffer of two frames, and the frame that waits in the shift register.
struct UsartReceiver {
  uint16_t frames[3] = {0, 0, 0};
  uint8_t count = 0;
  bool overrun = false;    ///< DOR
  uint16_t last_read = 0;  ///< what UDR returns if no frame waits

  /// Adds a frame. Returns false if the frame has replaced another one.
  bool add(uint16_t frame) {
    const bool fits = count < 3;
    if (fits) ++count;
    frames[count - 1] = frame;
    overrun |= !fits;
    return fits;
  }
  /// Returns the frame that the next read of UDR returns.
  uint16_t next() const { return count > 0 ? frames[0] : last_read; }
  /// Reads UDR.
  uint16_t take() {
    last_read = next();
    frames[0] = frames[1];
    frames[1] = frames[2];
    if (count > 0) --count;
    overrun = false;
    return last_read;
  }
  /// Empties the buffer (RXEN = 0).
  void clear() {
    count = 0;
    overrun = false;
  }
};

}  // namespace avr
}  // namespace robosim
