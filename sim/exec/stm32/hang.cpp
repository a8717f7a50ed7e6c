#include "sim/exec/stm32/hang.h"

namespace robosim::exec::stm32 {

bool hangs(const Machine& machine, const Firmware& firmware) {
  using namespace robosim::stm32;
  if (machine.is_off()) return true;
  if (!firmware.symbols.find("robosim_millis") || machine.bus().may_reset()) return false;
  // Masked ones count: a loop may mask them for a moment, to read what a handler writes.
  const Nvic& nvic = machine.nvic();
  for (int irq = 0; irq < kIrqCount; ++irq)
    if (nvic.is_enabled(static_cast<Irq>(irq)) && irq != kIrqTim2 && irq != kIrqUsart1) return false;
  return true;
}

}  // namespace robosim::exec::stm32
