#include "sim/executors/stm32/machine.h"

#include <algorithm>

namespace robosim::executors::stm32 {

using namespace robosim::stm32;

Machine::Machine(const Firmware& firmware, std::optional<std::uint32_t> loop, BoardState& board,
                 EepromPages& pages, SimTime t)
    : firmware_(firmware),
      board_(board),
      bus_(board, pages, t),
      cpu_(firmware, bus_, loop),
      stack_top_(cpu_.lowest_sp()) {
  if (const Symbol* end = firmware.symbols.find("robosim_heap_end")) heap_pointer_ = end->address;
}

void Machine::set_clock(SimTime start) {
  const Symbol* const main = firmware_.symbols.find("main");
  const Symbol* const millis = firmware_.symbols.find("robosim_millis");
  if (main && millis)
    cpu_.set_at(main->address, millis->address, static_cast<std::uint32_t>(start / kMillisecond));
}

void Machine::look_at_heap() {
  if (!heap_pointer_) return;
  const Address end = cpu_.word(heap_pointer_);
  if (end > cpu_.stack_limit() && end < kRam + kRamBytes) cpu_.set_stack_limit(end);
}

void Machine::run_until(SimTime t) {
  Clock& clock = bus_.link().clock;
  clock.limit = t;
  look_at_heap();
  while (clock.time_of(clock.now) < t && !cpu_.fault() && !off_) {
    bus_.update();
    bus_.take_inputs();
    cpu_.take_exception();
    const Cycle next = std::min(bus_.next_event(), clock.cycle_at(std::min(board_.next_input(), t)));
    const Cycle stop = std::max(std::min(next, clock.cycle_at(t)), clock.now + 1);
    if (cpu_.is_asleep())
      cpu_.sleep_to(stop);
    else
      cpu_.run_to(stop);
  }
}

Resources Machine::resources() const {
  constexpr double kNanoToMicro = 1e-3;
  const LoopTimes& loops = cpu_.loop_times();
  const auto cycles = static_cast<double>(std::max<Cycle>(bus_.link().clock.now, 1));
  Resources r;
  r.flash_bytes = firmware_.flash_bytes;
  r.ram_bytes = firmware_.ram_bytes;
  r.stack_bytes_max = stack_top_ - std::min(cpu_.lowest_sp(), stack_top_);
  r.loops = loops.count;
  r.loop_us_max = static_cast<double>(std::max(loops.longest, cpu_.present_loop())) * kNanoToMicro;
  if (r.loops > 0)
    r.loop_us_mean = static_cast<double>(loops.total) * kNanoToMicro / static_cast<double>(r.loops);
  r.interrupt_share = static_cast<double>(cpu_.handler_cycles()) / cycles;
  r.cpu_load = 1.0 - static_cast<double>(cpu_.sleep_cycles()) / cycles;
  return r;
}

}  // namespace robosim::executors::stm32
