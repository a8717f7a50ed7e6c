// The serial peripheral interface as master. Data sheet DS40002061B, chapter 19.
//
//   transfer   8 bits of D cycles from the write of SPDR on; then SPIF is set
//   D          4, 16, 64, 128 by SPR, half of it with SPI2X (table 19-5)
//
// Writing SPDR during a transfer sets WCOL and changes nothing. Reading SPSR while the flags are set, and
// then accessing SPDR, clears both; its vector clears SPIF, too. The received byte is the level of MISO at
// the end, since bits are not simulated. SS as an input at low level ends being master: MSTR is cleared and
// SPIF set. As a slave it does nothing, since it has no clock.
#pragma once

#include <cstdint>

#include "sim/avr/pins.h"

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
