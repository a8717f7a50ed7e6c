// Models the UART on the host (hal/board/avr_usart.h). The transmitter has a data register and a shift
// register.
#pragma once

#include <stdint.h>

#include "hal/board/avr_usart.h"
#include "hal/board/sim_time.h"
#include "hal/host/interrupts.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Uart {
 public:
  uint8_t status() const;
  void set_status(uint8_t value);
  uint8_t control() const { return control_; }
  void set_control(uint8_t value);
  uint8_t format() const { return format_; }
  void set_format(uint8_t value);
  uint16_t divider() const { return divider_; }
  void set_divider(uint16_t value);

  /// Returns the duration of a byte on the line, including start, parity and stop bits.
  SimTime byte_time() const { return byte_time_; }
  /// Returns the number of accepted bytes that have not been sent completely.
  int64_t sending() const;
  /// Returns the time from which on at most `count` accepted bytes are still unsent.
  SimTime until_sending(int64_t count) const { return sent_ - count * byte_time_; }
  /// Accepts a byte, even if the chip's data register is full. To respect the chip's limit, check sending()
  /// first.
  void send(uint8_t byte);

  /// Handles an incoming byte.
  void receive(uint8_t byte);
  /// Removes and returns the receiver's oldest byte (UDR0). Without a new byte, returns the previous byte
  /// again.
  uint8_t take() { return static_cast<uint8_t>(receiver_.take()); }
  bool has_byte() const { return receiver_.count > 0; }

  /// Returns the vectors 18..20 that are raised and enabled, one bit each.
  uint32_t pending() const {
    if (control_ & (kTxcie | kUdrie)) return pending_to_send();
    return static_cast<uint32_t>(has_byte() && control_ & kRxcie) << kUartReceived;
  }
  bool sends_by_interrupt() const { return control_ & (kTxcie | kUdrie); }
  SimTime next() const { return control_ & (kTxcie | kUdrie) ? next_to_send() : kNever; }
  /// Returns whether an interrupt that Serial does not handle may occur.
  bool may_interrupt() const;
  void acknowledge_sent() { sent_seen_ = true; }

 private:
  void refresh();
  uint32_t pending_to_send() const;
  SimTime next_to_send() const;

  uint8_t control_ = 0, format_ = avr::kUcsrcAtReset;
  uint8_t speed_ = 0;      ///< the bit U2X
  bool sent_seen_ = true;  ///< TXC was cleared after the last byte was sent
  uint16_t divider_ = 0;
  SimTime byte_time_ = 0;
  SimTime sent_ = 0;  ///< when the last byte ends
  avr::UsartReceiver receiver_;
};

extern Uart uart;
/// Returns whether arriving bytes are received by Serial, not by an ISR of the sketch.
bool serial_receives();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
