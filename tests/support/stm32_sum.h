// Hashes the state of an emulated STM32F103.
#pragma once

#include <cstdint>

#include "sim/exec/stm32/machine.h"
#include "tests/support/sum.h"

namespace robosim::run {

inline std::uint64_t sum_of(const exec::stm32::Machine& machine) {
  using namespace robosim::stm32;
  const auto& cpu = machine.cpu();
  Sum sum;
  for (int number = 0; number < 15; ++number) sum.add(cpu.reg(number));
  for (const std::uint32_t value : {cpu.status(), cpu.pc(), cpu.next_pc(), cpu.last_io_pc(), cpu.lowest_sp()})
    sum.add(value);
  for (const std::uint64_t value : {machine.bus().link().clock.now, cpu.last_io(), cpu.handler_cycles(),
                                    cpu.sleep_cycles(), machine.bus().ports().last_read_at()})
    sum.add(value);
  sum.add(cpu.rounds().count());
  sum.add(static_cast<std::uint64_t>(cpu.rounds().total()));
  sum.add(static_cast<std::uint64_t>(cpu.rounds().longest(0)));
  for (const std::uint32_t jump : cpu.last_jumps()) sum.add(jump);
  for (Address at = kRam; at < kRam + kRamBytes; at += 4) sum.add(cpu.word(at));
  return sum.value();
}

}  // namespace robosim::run
