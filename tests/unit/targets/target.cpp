#include "tests/unit/targets/target.h"

#include "sim/exec/host/host_executor.h"
#ifdef ROBOSIM_HAS_AVR
#include "sim/exec/avr/avr_executor.h"
#include "sim/exec/avr/firmware.h"
#include "sim/mcu/avr/chip.h"
#include "tests/support/sum.h"
#endif
#ifdef ROBOSIM_HAS_STM32
#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "tests/support/stm32_sum.h"
#endif

namespace robosim::exec {
namespace {

template <class Made>
std::unique_ptr<Executor> make(const BoardSpec& board, const std::filesystem::path& image) {
  return std::make_unique<Made>(board, image);
}
template <class Made>
void run_waiting_loops(Executor& executor) {
  static_cast<Made&>(executor).run_waiting_loops();
}

// At 16 MHz, the rate nearest to 9600 baud is 9615 baud (UBRR = 207 with U2X).
constexpr double kAtmegaByte_us = 1040;

#ifdef ROBOSIM_HAS_AVR
std::uint32_t address_in_avr(const std::filesystem::path& image, const BoardSpec& board, const char* name) {
  const auto firmware = avr::Firmware::read(image, board);
  const auto data = firmware.find_variable(name);
  return data ? 0x800000u + *data : firmware.find(name).value_or(0);
}

std::uint64_t state_of_avr(Executor& executor) {
  const robosim::avr::Chip* const chip = static_cast<AvrExecutor&>(executor).chip();
  if (!chip) return 0;
  const robosim::avr::Cpu& cpu = chip->cpu();
  const robosim::avr::Cpu::State& state = cpu.state;
  run::Sum sum;
  for (const std::uint64_t value : {state.cycle, state.last_io, state.handler_cycles}) sum.add(value);
  for (const std::uint64_t value : {state.pc, state.last_io_pc, state.jump_count}) sum.add(value);
  sum.add(state.sp);
  sum.add(state.sreg);
  for (const std::uint32_t jump : state.jumps) sum.add(jump);
  for (const std::uint8_t byte : cpu.data) sum.add(byte);
  return sum.value();
}

double skipped_share_of_avr(Executor& executor) {
  const robosim::avr::Chip& chip = *static_cast<AvrExecutor&>(executor).chip();
  return static_cast<double>(chip.idle().skipped()) / static_cast<double>(chip.cycle());
}
#endif

#ifdef ROBOSIM_HAS_STM32
std::uint32_t address_in_stm32(const std::filesystem::path& image, const BoardSpec& board, const char* name) {
  const auto* const symbol = stm32::Firmware::read(image, board).symbols.find(name);
  return symbol ? symbol->address : 0;
}

std::uint64_t state_of_stm32(Executor& executor) {
  const stm32::Machine* const machine = static_cast<Stm32Executor&>(executor).machine();
  return machine ? run::sum_of(*machine) : 0;
}

double skipped_share_of_stm32(Executor& executor) {
  const stm32::Machine& machine = *static_cast<Stm32Executor&>(executor).machine();
  return static_cast<double>(machine.cpu().idle().skipped()) /
         static_cast<double>(machine.bus().link().clock.now);
}
#endif

const Target kTargets[] = {
    {"host", "uno", make<HostExecutor>, kAtmegaByte_us, 10, true},
#ifdef ROBOSIM_HAS_AVR
    {"avr", "uno", make<AvrExecutor>, kAtmegaByte_us, 5, false, "uno5", "uno3", "22", "__vector_16",
     "timer0_millis", address_in_avr, run_waiting_loops<AvrExecutor>, state_of_avr, skipped_share_of_avr},
#endif
#ifdef ROBOSIM_HAS_STM32
    {"stm32", "bluepill", make<Stm32Executor>, 1e7 / 9600, 5, false, "bluepill5", "bluepill3", "f",
     "SysTick_Handler", "robosim_millis", address_in_stm32, run_waiting_loops<Stm32Executor>, state_of_stm32,
     skipped_share_of_stm32},
#endif
};

}  // namespace

const Target* find_target(const std::string& name) {
  for (const Target& target : kTargets)
    if (target.name == name) return &target;
  return nullptr;
}

std::vector<Target> targets(std::initializer_list<const char*> names) {
  std::vector<Target> found;
  for (const char* const name : names)
    if (const Target* const target = find_target(name)) found.push_back(*target);
  return found;
}

}  // namespace robosim::exec
