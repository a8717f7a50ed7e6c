// Models the serial peripheral interface as master on the host (data sheet, chapter 19). A byte takes 8 bits
// of 4, 16, 64 or 128 cycles each. SPI2X halves these durations. Single bits are not simulated. The received
// byte is 0xFF if MISO is high at the end, else 0. Unlike on the chip, the port's registers still drive MOSI
// and SCK. SS is read only when SPCR or SPDR is written.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {
namespace host {

class Spi {
 public:
  uint8_t control() const { return control_; }
  void set_control(uint8_t value);
  /// Reads SPSR. The next access to the data register clears the flags that this read returned.
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
