// Models the serial peripheral interface as master (data sheet DS40002061B, chapter 19): interrupt and pins.
// hal/board/avr_spi.h models its registers. In slave mode, nothing happens, because the model has no other
// master that provides a clock.
#pragma once

#include <cstdint>

#include "hal/board/avr_spi.h"
#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class Spi final : public Peripheral {
 public:
  Spi(Core& core, Pins& pins);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    SpiMaster master;
    std::uint8_t sending = 0;
    bool takes_pins = false;
    bool runs = true;
    Core::Held held;
  };

  std::uint8_t read(Address address);
  ReadForecast forecast(Address address, std::uint8_t bits);
  void write(Address address, std::uint8_t value);
  void send(std::uint8_t value);
  void shifted(Cycle at);
  void entered(int vector);
  void look_at_select();
  void drive();
  void request();

  Core& core_;
  Pins& pins_;
  Address control_, status_, data_;
  int select_, out_, in_, clock_;  ///< pins: SS, MOSI, MISO, SCK
  Events::Id shifted_ = 0;
  State state_;
};

}  // namespace robosim::avr
