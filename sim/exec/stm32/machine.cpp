#include "sim/exec/stm32/machine.h"

#include <algorithm>

#include "sim/exec/stm32/debug_port.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

Machine::Machine(const Firmware& firmware, const LoopMarks& loop, ClockedBoard& board, FlashMemory& memory,
                 Engine& engine, SimTime t)
    : firmware_(firmware),
      board_(board),
      bus_(board, memory, t),
      cpu_(firmware, bus_, engine, loop),
      stack_top_(cpu_.lowest_sp()) {
  if (const Symbol* end = firmware.symbols.find("robosim_heap_end")) heap_pointer_ = end->address;
}

void Machine::set_debug_port(DebugPort* port) {
  debug_port_ = port;
  if (port) port->plug_into(*this);
}

void Machine::restore(const Saved& saved) {
  state_ = saved.own;
  bus_.restore(saved.bus);
  cpu_.restore(saved.cpu);
}

void Machine::set_clock(SimTime start) {
  const Symbol* const main = firmware_.symbols.find("main");
  const Symbol* const millis = firmware_.symbols.find("robosim_millis");
  if (main && millis)
    cpu_.set_at(main->address, millis->address, static_cast<std::uint32_t>(start / kMillisecond));
}

std::vector<std::uint32_t> Machine::open_calls() const {
  constexpr std::size_t kMostCandidates = 40;
  std::vector<std::uint32_t> calls;
  const auto add = [&](std::uint32_t word) {
    const std::uint32_t pc = word & ~1u;
    if (!(word & 1) || pc < kFlash + 4 || !firmware_.has_code(pc)) return;
    const unsigned first = firmware_.half(pc - 4), second = firmware_.half(pc - 2);
    if ((first & 0xF800) == 0xF000 && (second & 0xD000) == 0xD000)
      calls.push_back(pc - 4);
    else if ((second & 0xFF87) == 0x4780)
      calls.push_back(pc - 2);
  };
  add(cpu_.reg(Cpu::kLr));
  for (Address at = cpu_.reg(Cpu::kSp) & ~3u; at + 4 <= kRam + kRamBytes && calls.size() < kMostCandidates;
       at += 4)
    add(cpu_.word(at));
  return calls;
}

void Machine::trace_bytes(TxProvenance& bytes) {
  if (const Symbol* const write = firmware_.symbols.find(TxProvenance::kFunction))
    cpu_.watch(write->address, [this, &bytes] { write_called(bytes); });
}

void Machine::write_called(TxProvenance& bytes) {
  constexpr int kByte = 1;  // the argument after `this`
  bytes.wrote(static_cast<std::uint8_t>(cpu_.reg(kByte)), board_.to_world(bus_.link().clock.time()));
}

void Machine::look_at_heap() {
  if (!heap_pointer_) return;
  const Address end = cpu_.word(heap_pointer_);
  if (end > cpu_.stack_limit() && end < kRam + kRamBytes) cpu_.set_stack_limit(end);
}

void Machine::restart() {
  const SimTime now = bus_.link().clock.time_of(bus_.link().clock.now);
  if (bus_.link().reset_cause != Reset::software && state_.watchdog_resets.add(now))
    return cpu_.fail(Fault::Kind::watchdog, cpu_.pc());
  bus_.reset();
  cpu_.reset();
}

void Machine::run_until(SimTime t) {
  Clock& clock = bus_.link().clock;
  clock.limit = t;
  look_at_heap();
  if (debug_port_) debug_port_->begin_tick();
  while (clock.now < clock.cycle_at(t) && !cpu_.fault()) {
    const bool is_due = clock.now >= bus_.next_event();
    bus_.update();
    bus_.take_inputs();
    if (bus_.link().reset_cause != Reset::none) restart();
    cpu_.take_exception();
    const Cycle next = std::min(bus_.next_event(), clock.cycle_at(std::min(board_.next_input(), t)));
    // Runs single steps to find changes of watched RAM. During sleep, single steps are necessary only if an
    // event is due, because instructions do not run.
    const bool singly = debug_port_ && (!cpu_.is_asleep() || is_due) && debug_port_->steps_singly();
    const Cycle stop = singly ? clock.now + 1 : std::max(std::min(next, clock.cycle_at(t)), clock.now + 1);
    if (cpu_.is_asleep())
      cpu_.sleep_to(stop);
    else
      cpu_.run_to(stop);
    if (debug_port_) debug_port_->ran(cpu_.take_breakpoint());
  }
}

Resources Machine::resources() const {
  constexpr double kNanoToMicro = 1e-3;
  const LoopTimer<SimTime>& rounds = cpu_.rounds();
  const auto cycles = static_cast<double>(std::max<Cycle>(bus_.link().clock.now, 1));
  Resources r;
  r.flash_bytes = firmware_.flash_bytes;
  r.ram_bytes = firmware_.ram_bytes;
  const Address lowest = std::min(cpu_.lowest_sp(), stack_top_);
  r.stack_bytes_max = stack_top_ - lowest;
  r.free_bytes_min = lowest - std::min(cpu_.stack_limit(), lowest);
  r.loops = rounds.count();
  r.loop_us_max = static_cast<double>(rounds.longest(time_of(bus_.link().clock.now))) * kNanoToMicro;
  if (r.loops > 0)
    r.loop_us_mean = static_cast<double>(rounds.total()) * kNanoToMicro / static_cast<double>(r.loops);
  r.interrupt_share = static_cast<double>(cpu_.handler_cycles()) / cycles;
  r.cpu_load = 1.0 - static_cast<double>(cpu_.sleep_cycles()) / cycles;
  return r;
}

}  // namespace robosim::exec::stm32
