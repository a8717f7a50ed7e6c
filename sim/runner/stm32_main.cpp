// The runner for the target stm32, and for runs that also have robots on the targets avr and host. The
// program links libunicorn and is therefore under the GPL-2 (sim/exec/stm32/unicorn.h).
#include "sim/exec/stm32/stm32_executor.h"
#include "sim/runner/avr_target.h"
#include "sim/runner/targets.h"

int main() {
  using namespace robosim::runner;
  const ExecutorFactory stm32 = {"stm32", [](const auto& board, const auto& image) {
                                   return std::make_unique<robosim::exec::Stm32Executor>(board, image);
                                 }};
  return serve(beside(stm32, {avr_target(), host_target()}));
}
