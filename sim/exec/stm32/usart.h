// USART1 to USART3 (RM0008 27): a byte takes (1 + 8 or 9 + stop bits) * BRR cycles of its bus. Sending: a
// shift register and one byte waiting. Receiving: one byte waits, a further one is lost (ORE). Framing and
// parity errors do not occur. Only the board's serial port leads anywhere: what the others send is dropped
// after its time, and nothing comes in by them.
#pragma once

#include "sim/exec/stm32/clocks.h"

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
  /// `index`: among the chip's.
  Usart(Link& link, const Clocks& clocks, int index)
      : link_(link),
        clocks_(clocks),
        spec_(stm32f103c8::kUarts[index]),
        connected_(index == link.board.spec().serial_line) {}

  Address base() const { return spec_.address; }
  bool owns(Address address) const { return address >= base() && address <= base() + kBytes; }
  /// 1 to 3, as it is called.
  int number() const { return spec_.number; }
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
  static constexpr Address kBytes = robosim::stm32::kUsartGtpr - robosim::stm32::kUsart1;

  bool on() const { return control_ & robosim::stm32::kUe; }
  Cycle byte_cycles() const;
  void send(std::uint8_t byte);
  void listen();
  void refresh_line();

  Link& link_;
  const Clocks& clocks_;
  const UartSpec& spec_;
  bool connected_;  ///< to the board's serial port
};

}  // namespace robosim::exec::stm32
