// SPI1 and SPI2 as masters (RM0008 25), with nothing connected: what they receive is the level of MISO's pin
// when a frame ends, in each of its bits. A frame takes 8 or 16 * 2^(BR + 1) cycles of its bus. SCK and MOSI
// are told as at rest. Refused, as not modelled: I2S, the hardware CRC, and masters that only receive. A
// slave waits for ever.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

/// What a reset of an SPI resets.
struct SpiRegisters {
  std::uint32_t control_ = 0, control2_ = 0, status_ = 2, crc_ = 7;
  std::uint32_t waiting_ = 0, received_ = 0;
  bool shifting_ = false;
  Cycle done_at_ = 0;
};

class Spi final : public Peripheral, SpiRegisters {
 public:
  /// `number`: 1 or 2.
  Spi(Link& link, const Clocks& clocks, int number);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override { return shifting_ ? done_at_ : kNoCycle; }
  void update() override;
  unsigned dma_requests() const override;

 private:
  bool masters() const;
  void shift(Cycle at);
  void refresh_line();
  void refresh_pins();

  Link& link_;
  const Clocks& clocks_;
  int number_;
  Address base_;
};

}  // namespace robosim::exec::stm32
