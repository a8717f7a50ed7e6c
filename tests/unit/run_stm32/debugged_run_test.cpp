// Runs the tests of debugged_run.h on target stm32.
#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/stm32_executor.h"

namespace robosim::runner {
namespace {

struct Target {
  using Executor = exec::Stm32Executor;
  static constexpr const char *kName = "stm32", *kRobot = "bluepill5", *kPc = "f",
                              *kTicks = "SysTick_Handler", *kMillis = "robosim_millis";
  static std::uint32_t address_of(const std::filesystem::path& image, const BoardSpec& board,
                                  const char* name) {
    const auto* const symbol = exec::stm32::Firmware::read(image, board).symbols.find(name);
    return symbol ? symbol->address : 0;
  }
};

}  // namespace
}  // namespace robosim::runner

#include "tests/support/debugged_run.h"
