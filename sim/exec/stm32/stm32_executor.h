// Executes firmware for STM32 boards on an emulated STM32F103 (libunicorn; see stm32/unicorn.h about its
// licence).
//
//   ELF ──► Cpu (libunicorn) ──► Bus: Clocks, Ports, Adc, Timers, Usart, Flash ──► FirmwarePort
//
// Time is counted in processor cycles, by a table (stm32/cycles.h).
#pragma once

#include <filesystem>

#include "sim/exec/chip/chip_executor.h"

namespace robosim::exec {

namespace stm32 {
class Machine;
}

class Stm32Executor final : public ChipExecutor {
 public:
  /// Loads `image`. Throws InputError if it is not an ELF file that this board's chip can run.
  Stm32Executor(const BoardSpec& spec, const std::filesystem::path& image);

  // --- for tests
  /// From the next power-on, executes waiting loops instead of skipping them (stm32::Idle).
  void run_waiting_loops();
  /// Returns the chip; null while the power is off.
  const stm32::Machine* machine() const;

 private:
  struct Image;
  class Firmware;
  class Running;

  Stm32Executor(const BoardSpec& spec, Firmware* firmware);  ///< takes ownership of `firmware`

  Firmware& firmware_;
};

}  // namespace robosim::exec
