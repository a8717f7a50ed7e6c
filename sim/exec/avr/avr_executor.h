// The target avr: the very ELF that is flashed, in an emulated chip (sim/avr).
//
//   ELF ──► WatchedChip ── Chip of sim/avr ──► Outside ──► FirmwarePort
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
  /// Throws InputError if `image` is no ELF that this board's chip can run.
  AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image);

  // --- for tests
  /// From the next power-on on, loops that wait are run, too, and nothing is left out (robosim::avr::Idle).
  void run_waiting_loops();
  /// null while the power is off.
  const robosim::avr::Chip* chip() const;

 private:
  struct Image;
  class Firmware;
  class Running;

  AvrExecutor(const BoardSpec& spec, Firmware* firmware);  ///< which becomes its own

  Firmware& firmware_;
};

}  // namespace robosim::exec
