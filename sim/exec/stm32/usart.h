// USART1 (RM0008 27): a byte takes (1 + 8 or 9 + stop bits) * BRR cycles. Sending: a shift register and one
// byte waiting. Receiving: one byte waits, a further one is lost (ORE). Framing and parity errors do not
// occur.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// What a reset of a USART resets.
struct UsartRegisters {
  std::uint32_t status_ = robosim::stm32::kTxe | robosim::stm32::kTc;
  std::uint32_t control_ = 0, control2_ = 0, divider_ = 0;
  bool shifting_ = false;
  Cycle sent_at_ = 0;
  std::uint8_t received_ = 0;
};

class Usart : UsartRegisters {
 public:
  explicit Usart(Link& link) : link_(link) {}

  static bool owns(Address address) {
    return address >= robosim::stm32::kUsart1 && address <= robosim::stm32::kUsartGtpr;
  }
  std::uint32_t read(Address address);
  bool write(Address address, std::uint32_t value);
  /// As after power-on.
  void reset();
  void receive(std::uint8_t byte);
  /// Whether it drives its TX pin.
  bool sends() const { return on() && control_ & robosim::stm32::kTe; }

  Cycle next_event() const { return shifting_ ? sent_at_ : kNoCycle; }
  void update();

 private:
  bool on() const { return control_ & robosim::stm32::kUe; }
  Cycle byte_cycles() const;
  void send(std::uint8_t byte);
  void listen();
  void refresh_line();

  Link& link_;
};

}  // namespace robosim::exec::stm32
