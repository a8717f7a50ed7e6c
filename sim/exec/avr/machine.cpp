#include "sim/exec/avr/machine.h"

#include <algorithm>

#include "sim/exec/avr/debug_port.h"
#include "sim/exec/avr/why/instruction_log.h"

namespace robosim::exec::avr {
namespace {

// The number of cycles between two checks of the size of the heap.
constexpr Cycle kLookEvery = 1000;

}  // namespace

Machine::Machine(const Firmware& firmware, const LoopMarks& loop, ClockedBoard& board, SimTime t)
    : BoardAdapter(board, t),
      firmware_(firmware),
      loop_(loop),
      board_(board),
      chip_(firmware, board.spec(), *this),
      stack_(chip_, firmware) {
  plug_in(chip_.chip());
  chip_.count(state_.rounds);
  for (const std::uint32_t pc : loop.each) chip_.set_trap(WatchedChip::kLoopTrap, pc);
  await_loop();
  look_ = chip_.chip().core().events.add<&Machine::look_at_heap>(this);
  chip_.chip().core().events.let_wait(look_);
  look_at_heap(0);
}

Machine::~Machine() = default;

void Machine::restore(const Saved& saved) {
  chip_.restore(saved.chip);
  BoardAdapter::restore(saved.adapter);
  stack_.restore(saved.stack);
  state_ = saved.own;
}

void Machine::look_at_heap(Cycle at) {
  if (!stack_.has_heap()) return;
  stack_.look();
  // This event may be handled late, like all events that are due while the chip sleeps. Skips the checks that
  // were missed.
  const Cycle missed = (chip_.cycle() - std::min(at, chip_.cycle())) / kLookEvery;
  chip_.chip().core().schedule(look_, at + (missed + 1) * kLookEvery);
}

void Machine::was_reset(std::uint8_t, Cycle at) {
  await_loop();
  chip_.was_reset();
  look_at_heap(at);
}

void Machine::await_loop() {
  state_.rounds.await();
  for (const std::uint32_t pc : loop_.first) chip_.set_trap(WatchedChip::kFirstLoopTrap, pc);
}

void Machine::loop_began() {
  if (!state_.rounds.is_running())
    for (const std::uint32_t pc : loop_.first) chip_.clear_trap(WatchedChip::kFirstLoopTrap, pc);
  state_.rounds.began(chip_.cycle());
}

void Machine::set_debug_port(DebugPort* port) {
  debug_port_ = port;
  if (port) port->plug_into(*this);
}

void Machine::log_into(InstructionLog* log) {
  log_ = log;
  chip_.step_singly(log != nullptr);
}

std::uint8_t Machine::peek(reg::Address address) {
  bool counter = false;
  for (int i = 0; i < chip_.spec().timer_count; ++i) {
    const TimerSpec& timer = chip_.spec().timers[i];
    counter |= address >= timer.count && address < timer.count + timer.bits / 8;
  }
  robosim::avr::Cpu& cpu = chip_.chip().cpu();
  const bool kept_elsewhere =
      counter || address == reg::kSreg || address == reg::kSpL || address == reg::kSpH;
  if (!kept_elsewhere) return chip_.data(address);
  const auto before = cpu.state;
  const std::uint8_t value = cpu.load(address);
  cpu.state = before;
  return value;
}

void Machine::poke(reg::Address address, std::uint8_t value) { chip_.chip().cpu().store(address, value); }

void Machine::trace_bytes(TxProvenance& bytes) {
  tx_provenance_ = &bytes;
  if (const auto write = firmware_.find(TxProvenance::kFunction))
    chip_.set_trap(WatchedChip::kWriteTrap, *write);
}

void Machine::write_called() {
  constexpr reg::Address kByte = 22;  // register in which avr-gcc passes the byte; 24 and 25 contain `this`
  tx_provenance_->wrote(chip_.data(kByte), board_.to_world(now()));
}

void Machine::set_clock(SimTime start) {
  state_.clock_start = start;
  if (const auto main = firmware_.find("main")) chip_.set_trap(WatchedChip::kMainTrap, *main);
}

void Machine::start_clock() {
  chip_.clear_trap(WatchedChip::kMainTrap, chip_.pc());
  // Sets the variables of the Arduino core (wiring.c): milliseconds, and overflows of timer 0.
  constexpr SimTime kOverflowCycles = 64 * 256;
  const auto set = [&](const char* variable, std::uint64_t value) {
    const auto address = firmware_.find_variable(variable);
    for (int i = 0; address && i < 4; ++i)
      chip_.chip().core().at(static_cast<reg::Address>(*address + i)) =
          static_cast<std::uint8_t>(value >> (8 * i));
  };
  set("timer0_millis", static_cast<std::uint64_t>(state_.clock_start / kMillisecond));
  set("timer0_overflow_count",
      static_cast<std::uint64_t>(state_.clock_start / clock_map().length_of(kOverflowCycles)));
}

Resources Machine::resources() const {
  const double cycle_us = 1e6 / chip_.clock_hz();
  Resources r;
  r.flash_bytes = static_cast<std::uint32_t>(firmware_.flash.size());
  r.ram_bytes = firmware_.ram_bytes;
  r.stack_bytes_max = stack_.most_bytes();
  r.free_bytes_min = stack_.least_free_bytes();
  r.loops = state_.rounds.count();
  r.loop_us_max = static_cast<double>(state_.rounds.longest(chip_.cycle())) * cycle_us;
  if (r.loops > 0)
    r.loop_us_mean = static_cast<double>(state_.rounds.total()) * cycle_us / static_cast<double>(r.loops);
  const auto all = static_cast<double>(std::max<Cycle>(chip_.cycle(), 1));
  r.interrupt_share = static_cast<double>(chip_.handler_cycles()) / all;
  r.cpu_load = 1.0 - static_cast<double>(chip_.sleep_cycles()) / all;
  return r;
}

void Machine::run_until(SimTime t) {
  if (debug_port_) debug_port_->begin_tick();
  Cycle end = clock_map().cycle_at(t);
  int divisions = clock_map().divisions();
  if (chip_.cycle() < end) take_inputs(chip_.cycle());
  while (chip_.cycle() < end && !chip_.fault() && !chip_.is_off()) {
    if (log_) log_->before();
    chip_.run_to(end);
    if (log_) log_->after();
    const unsigned traps = chip_.take_traps();
    if (traps & (WatchedChip::kLoopTrap | WatchedChip::kFirstLoopTrap)) loop_began();
    if (traps & WatchedChip::kMainTrap) start_clock();
    if (traps & WatchedChip::kWriteTrap) write_called();
    if (debug_port_) debug_port_->ran(traps & WatchedChip::kBreakpoint);
    if (clock_map().divisions() == divisions) continue;
    divisions = clock_map().divisions();
    end = clock_map().cycle_at(t);
  }
}

}  // namespace robosim::exec::avr
