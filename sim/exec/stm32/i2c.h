// Models I2C1 and I2C2 as masters (RM0008 26). The bus has pull-ups but no devices, so no address is
// acknowledged (AF). A bit takes N * CCR cycles of APB1, where N is 2, 3 or 25 (F/S and DUTY in I2C_CCR).
// Neither I2C is ever addressed as a slave. DMA requests do not occur, because no data is transferred. SMBus
// is not modelled and is refused.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class I2c final : public Peripheral {
 public:
  /// `number` is 1 or 2.
  I2c(Link& link, const Clocks& clocks, int number);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override { return state_.done_at; }
  void update() override;

 private:
  enum class Phase { idle, start, waits_for_address, address, refused, stop };
  /// State that an I2C reset restores to its defaults.
  struct State {
    std::uint32_t control = 0, control2 = 0, own = 0, own2 = 0, data = 0, status = 0, clock = 0, rise = 2;
    Phase phase = Phase::idle;
    Cycle done_at = kNoCycle;
  };

  bool masters() const { return state_.phase != Phase::idle && state_.phase != Phase::start; }
  Cycle bit_cycles() const;
  void begin(Phase phase, Cycle bits);
  void go_on();
  void refresh_lines();

  Link& link_;
  const Clocks& clocks_;
  const int number_;
  const Address base_;
  State state_;
};

}  // namespace robosim::exec::stm32
