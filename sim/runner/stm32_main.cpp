// The runner for the target stm32, and for runs that also have robots on the targets avr and host. The
// program links libunicorn and is therefore under the GPL-2 (sim/exec/stm32/unicorn.h).
#include "sim/exec/avr/avr_executor.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "sim/runner/targets.h"

int main() {
  using namespace robosim::runner;
  using namespace robosim::exec;
  return serve(beside(chip_target<Stm32Executor>("stm32"), {chip_target<AvrExecutor>("avr"), host_target()}));
}
