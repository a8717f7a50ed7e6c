// Models the UART on the host (data sheet DS40002061B, chapter 20). The transmitter has a data register and a
// shift register. The receiver buffers two bytes. A third byte waits in the shift register, where a fourth
// byte replaces the third.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"
#include "hal/host/interrupts.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Bits of UCSR0A and UCSR0B.
enum : uint8_t { kRxc = 0x80, kTxc = 0x40, kUdre = 0x20, kDor = 0x08, kU2x = 0x02 };
enum : uint8_t { kRxcie = 0x80, kTxcie = 0x40, kUdrie = 0x20, kRxen = 0x10, kTxen = 0x08 };

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
  /// Returns the time from which at most `count` accepted bytes are unsent.
  SimTime until_sending(int64_t count) const { return sent_ - count * byte_time_; }
  /// Accepts a byte, even if the chip's data register is full. To respect the chip's limit, check sending()
  /// first.
  void send(uint8_t byte);

  /// Handles an incoming byte.
  void receive(uint8_t byte);
  /// Removes and returns the receiver's oldest byte (UDR0). Without a new byte, returns the previous byte
  /// again.
  uint8_t take();
  bool has_byte() const { return waiting_ > 0; }

  /// Returns the vectors 18..20 that are raised and enabled, one bit each.
  uint32_t pending() const {
    if (control_ & (kTxcie | kUdrie)) return pending_to_send();
    return static_cast<uint32_t>(waiting_ > 0 && control_ & kRxcie) << kUartReceived;
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

  uint8_t control_ = 0, format_ = 0x06;
  bool double_speed_ = false, overrun_ = false;
  bool sent_seen_ = true;  ///< TXC was cleared after the last byte was sent
  uint16_t divider_ = 0;
  SimTime byte_time_ = 0;
  SimTime sent_ = 0;  ///< when the last byte ends
  uint8_t received_[3] = {0, 0, 0};
  uint8_t taken_ = 0;
  int waiting_ = 0;
};

extern Uart uart;
/// Returns whether arriving bytes are received by Serial, not by an ISR of the sketch.
bool serial_receives();
/// Resets the UART, and empties the buffers of Serial.
void reset_uart();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
