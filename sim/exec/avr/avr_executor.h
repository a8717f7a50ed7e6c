// Runs the flashed ELF file of an AVR board in an emulated chip (sim/mcu/avr).
//
//   ELF ──► WatchedChip ── Chip of sim/mcu/avr ──► BoardAdapter ──► FirmwarePort
//
// The chip uses the board's clock. A tick ends when the running instruction ends, up to 3 cycles late.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "sim/exec/chip/chip_executor.h"
#include "sim/exec/core/detector.h"

namespace robosim::avr {
class Chip;
}

namespace robosim::exec {

namespace avr {
struct RunningProgram;
}

/// Creates the detectors (sim/detect/avr) for a chip that is about to start. For `counted`, see
/// ChipAccess::detect().
using MakeChipDetectors = std::function<std::vector<std::unique_ptr<Detector>>(
    const avr::RunningProgram& program, const std::vector<Pin>& counted)>;

class AvrExecutor final : public ChipExecutor {
 public:
  /// Loads `image`. Throws InputError if this board's chip cannot run the image. Without `make_detectors`,
  /// detect() has no effect.
  AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image,
              MakeChipDetectors make_detectors = {});

  // --- for tests
  /// From the next power-on, executes waiting loops instead of skipping them (robosim::avr::Idle).
  void run_waiting_loops();
  /// Returns the chip; null while the power is off.
  const robosim::avr::Chip* chip() const;

 private:
  struct Image;
  class Firmware;
  class Running;

  AvrExecutor(const BoardSpec& spec, Firmware* firmware);  ///< takes ownership of `firmware`

  Firmware& firmware_;
};

}  // namespace robosim::exec
