// The target stm32: an emulated STM32F103 (libunicorn, see stm32/unicorn.h about its licence).
//
//   ELF ──► Cpu (libunicorn) ──► Bus: Clocks, Ports, Adc, Timers, Usart, Flash ──► FirmwarePort
//
// Time: processor cycles, by a table (stm32/cycles.h).
#pragma once

#include <filesystem>

#include "sim/exec/chip/chip_executor.h"

namespace robosim::exec {

namespace stm32 {
class Machine;
}

class Stm32Executor final : public ChipExecutor {
 public:
  /// Throws InputError if `image` is no ELF that this board's chip can run.
  Stm32Executor(const BoardSpec& spec, const std::filesystem::path& image);

  // --- for tests
  /// From the next power-on on, loops that wait are run, too, and nothing is left out (stm32::Idle).
  void run_waiting_loops();
  /// null while the power is off.
  const stm32::Machine* machine() const;

 private:
  struct Image;
  class Firmware;
  class Running;

  Stm32Executor(const BoardSpec& spec, Firmware* firmware);  ///< which becomes its own

  Firmware& firmware_;
};

}  // namespace robosim::exec
