#include "hal/host/uart.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"

namespace robosim {
namespace host {

Uart uart;

void Uart::refresh() {
  byte_time_ = cycles(avr::usart_frame(speed_, control_, format_, divider_));
  executor->listen(control_ & kRxen ? byte_time_ : 0, state.now);
}

uint8_t Uart::status() const {
  uint8_t value = speed_;
  if (has_byte()) value |= kRxc;
  if (receiver_.overrun) value |= kDor;
  if (sending() <= 1) value |= kUdre;
  if (!sent_seen_ && sending() == 0) value |= kTxc;
  return value;
}

void Uart::set_status(uint8_t value) {
  if (value & kTxc && sending() == 0) sent_seen_ = true;
  if ((value & kU2x) == speed_) return;
  speed_ = value & kU2x;
  refresh();
}

void Uart::set_control(uint8_t value) {
  control_ = value;
  if (!(value & kRxen)) receiver_.clear();
  refresh();
}

void Uart::set_format(uint8_t value) {
  format_ = value;
  refresh();
}

void Uart::set_divider(uint16_t value) {
  divider_ = value & 0xFFF;
  refresh();
}

int64_t Uart::sending() const {
  return sent_ > state.now && byte_time_ > 0 ? (sent_ - state.now + byte_time_ - 1) / byte_time_ : 0;
}

void Uart::send(uint8_t byte) {
  if (!(control_ & kTxen)) return;
  sent_ = (sent_ > state.now ? sent_ : state.now) + byte_time_;
  sent_seen_ = false;
  board->send_byte(byte, state.now);
}

void Uart::receive(uint8_t byte) {
  if (!(control_ & kRxen)) return;
  receiver_.add(byte);
}

uint32_t Uart::pending_to_send() const {
  const uint8_t raised = status() & control_;  // the enable bits have the positions of the flags
  return static_cast<uint32_t>((raised & kRxc) != 0) << kUartReceived |
         static_cast<uint32_t>((raised & kUdre) != 0) << kUartEmpty |
         static_cast<uint32_t>((raised & kTxc) != 0) << kUartSent;
}

bool Uart::may_interrupt() const {
  const bool receives = control_ & kRxen && control_ & kRxcie;
  return control_ & (kTxcie | kUdrie) || (receives && !serial_receives());
}

SimTime Uart::next_to_send() const {
  if (control_ & kUdrie) return sending() <= 1 ? state.now : sent_ - byte_time_;
  if (control_ & kTxcie && !sent_seen_) return sent_;
  return kNever;
}

}  // namespace host
}  // namespace robosim
