// Models the serial peripheral interface as master on the host (hal/board/avr_spi.h). Unlike on the chip, the
// port's registers drive MOSI and SCK even while SPI is on. SS is read only when SPCR or SPDR is written.
#pragma once

#include <stdint.h>

#include "hal/board/avr_spi.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host {

class Spi {
 public:
  uint8_t control() const { return control_; }
  void set_control(uint8_t value);
  /// Reads SPSR. The next access to the data register clears the flags that this read returned.
  uint8_t status() { return master_.read_status(status_); }
  void set_status(uint8_t value) { master_.write_status(status_, value); }
  uint8_t take();
  void send(uint8_t value);

  void sync();
  bool pending() const { return control_ & kSpie && status_ & kSpif; }
  bool may_interrupt() const { return control_ & kSpie && (master_.shifting || status_ & kSpif); }
  SimTime next() const { return master_.shifting && control_ & kSpie ? due_ : kNever; }
  void acknowledge() { status_ &= static_cast<uint8_t>(~kSpif); }

 private:
  void look_at_select();

  uint8_t control_ = 0, status_ = 0;
  avr::SpiMaster master_;
  SimTime due_ = 0;
};

extern Spi spi;

}  // namespace host
}  // namespace robosim
