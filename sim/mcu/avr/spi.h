// Models the serial peripheral interface as master (data sheet DS40002061B, chapter 19).
//
//   transfer   starts when SPDR is written; takes 8 bits of D cycles, and then sets SPIF
//   D          4, 16, 64 or 128, selected by SPR; SPI2X halves D (table 19-5)
//
// Writing SPDR during a transfer only sets WCOL. Reading SPSR while flags are set, and then accessing SPDR,
// clears these flags. Entering the vector also clears SPIF. Single bits are not simulated: each received bit
// is the level of MISO at the end of the transfer. If SS is an input at low level, master mode ends: MSTR is
// cleared, and SPIF is set. In slave mode, nothing happens, because no other master provides a clock.
#pragma once

#include <cstdint>

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
    std::uint8_t sending = 0, received = 0;
    std::uint8_t seen = 0;  ///< flags at the last read of SPSR
    bool shifting = false;
    bool takes_pins = false;
    bool runs = true;
    Core::Held held;
  };

  std::uint8_t read(Address address);
  ReadForecast forecast(Address address, std::uint8_t bits);
  void write(Address address, std::uint8_t value);
  void touch_data();
  void send(std::uint8_t value);
  void shifted(Cycle at);
  void entered(int vector);
  void look_at_select();
  void drive();
  void request();
  bool is_master() const;
  Cycle transfer() const;

  Core& core_;
  Pins& pins_;
  Address control_, status_, data_;
  int select_, out_, in_, clock_;  ///< pins: SS, MOSI, MISO, SCK
  Events::Id shifted_ = 0;
  State state_;
};

}  // namespace robosim::avr
