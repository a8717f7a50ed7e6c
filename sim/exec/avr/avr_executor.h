// The executor for AVR boards: runs the flashed ELF file itself, in an emulated chip (sim/avr).
//
//   ELF ──► WatchedChip ── Chip of sim/avr ──► BoardAdapter ──► FirmwarePort
//
// Time: the chip's clock is the board's; a tick may end up to 3 cycles late.
#pragma once

#include <filesystem>

#include "sim/exec/chip/chip_executor.h"

namespace robosim::avr {
class Chip;
}

namespace robosim::exec {

class AvrExecutor final : public ChipExecutor {
 public:
  /// Loads `image`. Throws InputError if it is not an ELF file that this board's chip can run.
  AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image);

  // --- for tests
  /// From the next power-on on, runs waiting loops, too, and skips nothing (robosim::avr::Idle).
  void run_waiting_loops();
  /// Returns the chip; null while the power is off.
  const robosim::avr::Chip* chip() const;

 private:
  struct Image;
  class Firmware;
  class Running;

  AvrExecutor(const BoardSpec& spec, Firmware* firmware);  ///< takes ownership of it

  Firmware& firmware_;
};

}  // namespace robosim::exec
