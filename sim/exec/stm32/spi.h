// Models SPI1 and SPI2 as masters (RM0008 25), without connected devices. All bits of a received frame have
// the level of the MISO pin at the frame's end. A frame takes (8 or 16) * 2^(BR + 1) cycles of the SPI's bus.
// SCK and MOSI are reported as idle. I2S, the hardware CRC, and masters that only receive are not modelled
// and are refused. An SPI that is configured as a slave waits for ever.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Spi final : public Peripheral {
 public:
  /// `number` is 1 or 2.
  Spi(Link& link, const Clocks& clocks, int number);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override { return state_.shifting ? state_.done_at : kNoCycle; }
  void update() override;
  unsigned dma_requests() const override;

 private:
  /// State that an SPI reset restores to its defaults.
  struct State {
    std::uint32_t control = 0, control2 = 0, status = 2, crc = 7;
    std::uint32_t waiting = 0, received = 0;
    bool shifting = false;
    Cycle done_at = 0;
  };

  bool masters() const;
  void shift(Cycle at);
  void refresh_line();
  void refresh_pins();

  Link& link_;
  const Clocks& clocks_;
  const int number_;
  const Address base_;
  State state_;
};

}  // namespace robosim::exec::stm32
