// Models the registers of an AVR's serial peripheral interface as master (ATmega328P, data sheet DS40002061B,
// chapter 19), for the target host and for the emulated chip.
//
//   transfer   starts when SPDR is written; takes 8 bits of D cycles, and then sets SPIF
//   D          4, 16, 64 or 128, selected by SPR; SPI2X halves D (table 19-5)
//
// Writing SPDR during a transfer only sets WCOL. Reading SPSR while flags are set, and then accessing SPDR,
// clears these flags. Entering the vector also clears SPIF. Single bits are not simulated: each received bit
// is the level of MISO at the end of the transfer. If SS is an input at low level, master mode ends: MSTR is
// cleared, and SPIF is set (19.3.2).
#pragma once

#include "hal/board/avr_registers.h"

namespace robosim {
namespace avr {

/// The caller stores SPCR and SPSR as `control` and `status`.
struct SpiMaster {
  uint8_t received = 0;   ///< SPDR
  uint8_t seen = 0;       ///< flags at the last read of SPSR
  bool shifting = false;  ///< a transfer is in progress

  static bool is_on(uint8_t control) { return control & kSpe && control & kMstr; }
  /// Returns the duration of a transfer in cycles.
  static int64_t takes(uint8_t control, uint8_t status) {
    const int bit = (control & kSpr) == 3 ? 128 : 4 << 2 * (control & kSpr);
    return 8 * (status & kSpi2x ? bit / 2 : bit);
  }
  uint8_t read_status(uint8_t status) {
    seen = status & (kSpif | kWcol);
    return status;
  }
  static void write_status(uint8_t& status, uint8_t value) {
    status = static_cast<uint8_t>((status & ~kSpi2x) | (value & kSpi2x));
  }
  /// Handles an access to SPDR.
  void touch_data(uint8_t& status) {
    status &= static_cast<uint8_t>(~seen);
    seen = 0;
  }
  /// Handles a write to SPDR, after touch_data(). Returns whether a transfer begins.
  bool begin(uint8_t control, uint8_t& status) {
    if (shifting) status |= kWcol;
    if (shifting || !is_on(control)) return false;
    return shifting = true;
  }
  void end(uint8_t& status, bool level_of_miso) {
    shifting = false;
    received = level_of_miso ? 0xFF : 0x00;
    status |= kSpif;
  }
  /// Handles the low level of SS.
  void lose_bus(uint8_t& control, uint8_t& status) {
    shifting = false;
    control &= static_cast<uint8_t>(~kMstr);
    status |= kSpif;
  }
};

}  // namespace avr
}  // namespace robosim
