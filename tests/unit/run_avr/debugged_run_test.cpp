// Runs the tests of debugged_run.h on target avr.
#include "sim/exec/avr/avr_executor.h"
#include "sim/exec/avr/firmware.h"

namespace robosim::runner {
namespace {

struct Target {
  using Executor = exec::AvrExecutor;
  static constexpr const char *kName = "avr", *kRobot = "uno5", *kPc = "22", *kTicks = "__vector_16",
                              *kMillis = "timer0_millis";
  static std::uint32_t address_of(const std::filesystem::path& image, const BoardSpec& board,
                                  const char* name) {
    const auto firmware = exec::avr::Firmware::read(image, board);
    const auto data = firmware.find_variable(name);
    return data ? 0x800000u + *data : firmware.find(name).value_or(0);
  }
};

}  // namespace
}  // namespace robosim::runner

#include "tests/support/debugged_run.h"
