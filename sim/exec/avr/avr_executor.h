// The target avr: an emulated ATmega328P (libsimavr, see avr/simavr.h about its licence).
//
//   ELF ──► Chip (libsimavr) ──► Ports, Adc, Uart ──► FirmwarePort
//
// Time: the chip's clock is the board's; a tick may end up to 3 cycles late.
#pragma once

#include <filesystem>

#include "sim/exec/chip/chip_executor.h"

namespace robosim::exec {

class AvrExecutor final : public ChipExecutor {
 public:
  /// Throws InputError if `image` is no ELF that this board's chip can run.
  AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image);
};

}  // namespace robosim::exec
