// The serial peripheral interface as master (datasheet, chapter 19). A byte takes 8 bits of 4, 16, 64 or 128
// cycles, half of that with SPI2X. The received byte is the level of MISO at the end. Bits are not simulated,
// and MOSI and SCK stay the port's. SS is read when SPCR or SPDR is written.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {
namespace host {

class Spi {
 public:
  uint8_t control() const { return control_; }
  void set_control(uint8_t value);
  /// Reads SPSR; the shown flags are cleared by the next access to the data.
  uint8_t status();
  void set_status(uint8_t value) { status_ = static_cast<uint8_t>((status_ & ~1) | (value & 1)); }
  uint8_t take();
  void send(uint8_t value);

  void sync();
  bool pending() const;
  bool may_interrupt() const;
  SimTime next() const;
  void acknowledge();

 private:
  void touch();
  bool is_master() const;
  void look_at_select();

  uint8_t control_ = 0, status_ = 0, seen_ = 0, received_ = 0;
  bool shifts_ = false;
  SimTime due_ = 0;
};

extern Spi spi;

}  // namespace host
}  // namespace robosim
