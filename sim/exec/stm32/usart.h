// Models USART1 to USART3 (RM0008 27). A byte takes (1 + 8 or 9 + stop bits) * BRR cycles of the USART's bus.
//
//   sending     one byte is in the shift register, and one further byte waits
//   receiving   one byte waits until firmware reads it; a further byte is lost (ORE)
//
// Framing and parity errors do not occur. Only the USART of the board's serial port is connected. The other
// USARTs drop each byte after its duration, and receive no bytes.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Usart final : public Peripheral {
 public:
  /// `index` is the USART's position in stm32f103c8::kUarts.
  Usart(Link& link, const Clocks& clocks, int index);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  /// Drives the TX pin while the transmitter is enabled.
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override {
    return std::min(state_.shifting ? state_.sent_at : kNoCycle, state_.idle_at);
  }
  // Returns 0 for USART_DR, since reading it clears flags.
  Cycle same_until(Address address) const override {
    return address == base() + robosim::stm32::kUsartDr - robosim::stm32::kUsart1 ? 0 : next_event();
  }
  unsigned dma_requests() const override;
  void update() override;
  void receive(std::uint8_t byte);

 private:
  /// State that a USART reset restores to its defaults.
  struct State {
    std::uint32_t status = robosim::stm32::kTxe | robosim::stm32::kTc;
    std::uint32_t control = 0, control2 = 0, control3 = 0, divider = 0;
    bool shifting = false;
    Cycle sent_at = 0, idle_at = kNoCycle;
    std::uint8_t received = 0, waiting = 0;
  };

  Address base() const { return spec_.address; }
  bool sends() const { return on() && state_.control & robosim::stm32::kTe; }
  bool on() const { return state_.control & robosim::stm32::kUe; }
  ChipPin pin_now() const;
  Cycle byte_cycles() const;
  void send(std::uint8_t byte);
  void shift(std::uint8_t byte, Cycle at);
  void listen();
  void refresh_line();

  Link& link_;
  const Clocks& clocks_;
  const UartSpec& spec_;
  const ChipPin pin_;     ///< TX pin after a reset
  const bool connected_;  ///< connected to the board's serial port
  State state_;
};

}  // namespace robosim::exec::stm32
