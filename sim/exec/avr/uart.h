// The UART, in place of libsimavr's, whose bytes take 11 bits, whose buffer holds 64 of them, and which sends
// a byte only when the one before has left.
//
// A byte takes (1 + data + parity + stop bits) * (8 or 16) * (UBRR + 1) cycles. Sending: a shift register and
// one byte waiting. Receiving: two bytes waiting, a further one is lost (DOR). Framing and parity errors do
// not occur.
#pragma once

#include <array>
#include <cstdint>

#include "sim/exec/avr/link.h"

namespace robosim::exec::avr {

class Uart {
 public:
  explicit Uart(Link& link, int number);

  bool owns(reg::Address address) const { return address >= status_at_ && address <= data_at_; }
  void write(reg::Address address, std::uint8_t value);
  std::uint8_t read(reg::Address address);
  void receive(std::uint8_t byte);
  void was_reset();

 private:
  static avr_cycle_count_t on_shifted(avr_t* avr, avr_cycle_count_t when, void* self);

  std::uint8_t& status() { return link_.chip.memory()[status_at_]; }
  std::uint8_t control() const { return link_.chip.data(control_at_); }
  Cycle byte_cycles() const;
  void send(std::uint8_t byte);
  std::uint8_t take();
  void set_control(std::uint8_t value);
  void listen();
  void raise(avr_int_vector_t& vector);
  void clear(avr_int_vector_t& vector, std::uint8_t flag);

  Link& link_;
  avr_uart_t* module_;
  reg::Address status_at_, control_at_, format_at_, divider_at_, data_at_;
  bool shifting_ = false;
  bool waiting_ = false;  ///< a byte waits for the shift register
  std::array<std::uint8_t, 2> received_{};
  int received_count_ = 0;
};

}  // namespace robosim::exec::avr
