// I2C1 and I2C2 as masters (RM0008 26), with no device on the bus, whose lines are pulled up: nobody answers
// an address (AF). A bit takes 2, 3 or 25 * CCR cycles of APB1. As slaves they are never addressed. Refused,
// as not modelled: SMBus. DMA has nothing to move.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

/// What a reset of an I2C resets.
struct I2cRegisters {
  enum class Phase { idle, start, waits_for_address, address, refused, stop };

  std::uint32_t control_ = 0, control2_ = 0, own_ = 0, own2_ = 0, data_ = 0, status_ = 0, clock_ = 0,
                rise_ = 2;
  Phase phase_ = Phase::idle;
  Cycle done_at_ = kNoCycle;
};

class I2c final : public Peripheral, I2cRegisters {
 public:
  /// `number`: 1 or 2.
  I2c(Link& link, const Clocks& clocks, int number);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override { return done_at_; }
  void update() override;

 private:
  bool masters() const { return phase_ != Phase::idle && phase_ != Phase::start; }
  Cycle bit_cycles() const;
  void begin(Phase phase, Cycle bits);
  void go_on();
  void refresh_lines();

  Link& link_;
  const Clocks& clocks_;
  int number_;
  Address base_;
};

}  // namespace robosim::exec::stm32
