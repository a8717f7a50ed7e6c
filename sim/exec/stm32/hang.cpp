#include "sim/exec/stm32/hang.h"

namespace robosim::exec::stm32 {

namespace {

using namespace robosim::stm32;

// A loop may briefly mask interrupts to read values that a handler writes. Interrupts count as masked for
// ever if an interrupt is pending and no handler has begun for this duration. Normally, the handler for the
// Arduino core's clock begins every 1 ms.
constexpr SimTime kMaskedFor = kSecond;

bool are_masked_for_good(const Machine& machine) {
  const Cpu& cpu = machine.cpu();
  const SimTime now = machine.time_of(machine.bus().link().clock.now);
  return !cpu.interruptible() && !cpu.in_handler() && machine.nvic().any_pending() &&
         now - machine.time_of(cpu.handler_began()) >= kMaskedFor;
}

}  // namespace

bool hangs(const Machine& machine, const Firmware& firmware) {
  if (!firmware.symbols.find("robosim_millis") || machine.bus().may_reset()) return false;
  if (are_masked_for_good(machine)) return true;
  const Nvic& nvic = machine.nvic();
  for (int irq = 0; irq < kIrqCount; ++irq)
    if (nvic.is_enabled(static_cast<Irq>(irq)) && irq != kIrqTim2 && irq != kIrqUsart1) return false;
  return true;
}

}  // namespace robosim::exec::stm32
