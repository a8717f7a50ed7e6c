#include "sim/exec/avr/watched_chip.h"

#include <algorithm>
#include <utility>

#include "hal/board/cycle_time.h"
#include "sim/base/elf/avr_addresses.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Chip;
using robosim::avr::Instruction;
using robosim::avr::Op;

constexpr std::size_t kLargestFlash = 0x10000;
constexpr std::uint8_t kErased = 0xFF;
constexpr std::uint16_t kErasedWord = 0xFFFF;
// Largest distance, in cycles, between the writes of the stack pointer's two halves. Unoptimised code
// computes the second half after the write of the first half.
constexpr Cycle kHalvesApart = 32;
// Largest distance, in instructions, between the computation of a stack pointer's value and its write.
constexpr std::uint32_t kLooksBack = 8;

bool is_load(Op op) { return (op >= Op::ld_x && op <= Op::lds) || op == Op::pop; }

bool is_arithmetic(Op op) {
  return (op >= Op::add && op <= Op::eor) || (op >= Op::subi && op <= Op::ori) || op == Op::adiw ||
         op == Op::sbiw;
}

/// The source of the value in a register.
struct Origin {
  Op op = Op::nop;           ///< the instruction that loaded the value: a load, IN or LDI; nop = unknown
  std::int32_t address = 0;  ///< for IN, the address of the I/O register
  bool is_changed = false;   ///< arithmetic has changed the loaded value
};

/// Returns the origin of the value that the last instruction has stored. Follows the value back through
/// copies from register to register.
Origin origin_of_stored_value(const robosim::avr::Cpu& cpu) {
  const std::uint32_t pc = cpu.last_pc();
  unsigned source = cpu.instruction(pc).a;
  bool is_changed = false;
  for (std::uint32_t back = 1; back <= kLooksBack && back < pc; ++back) {
    const Instruction& before = cpu.instruction(pc - back);
    const bool is_pair = before.op == Op::movw || before.op == Op::adiw || before.op == Op::sbiw;
    const bool is_second_word = cpu.instruction(pc - back - 1).words == 2;
    if (is_second_word || before.a != (is_pair ? source & ~1u : source)) continue;
    if (is_load(before.op) || before.op == Op::in || before.op == Op::ldi)
      return {before.op, before.k, is_changed};
    if (before.op == Op::mov || before.op == Op::movw) source = before.b + (is_pair ? source & 1 : 0);
    is_changed |= is_arithmetic(before.op);
  }
  return {};
}

std::vector<std::uint8_t> flash_of(const Firmware& firmware) {
  std::vector<std::uint8_t> flash = firmware.flash;
  flash.resize(firmware.needs_larger_chip() ? kLargestFlash : firmware.chip->flash_bytes, kErased);
  return flash;
}

/// Returns the target of the jump at the reset vector, in words.
std::uint32_t reset_target(const robosim::avr::Cpu& cpu) {
  const Instruction& first = cpu.instruction(0);
  const bool jumps = robosim::avr::control_of(first.op) == robosim::avr::Control::jump;
  return jumps ? robosim::avr::target_of(first, 0, cpu.chip().flash_bytes / 2) : 0;
}

}  // namespace

WatchedChip::WatchedChip(const Firmware& firmware, const BoardSpec& board,
                         robosim::avr::ChipEnvironment& outside)
    : firmware_(firmware),
      spec_(*board.chip),
      clock_hz_(board.clock_hz),
      has_boot_loader_(board.flash_bytes < board.chip->flash_bytes),
      chip_(spec_, flash_of(firmware), firmware.last_ram, outside, board.clock_hz) {
  using robosim::avr::Cpu;
  state_.lowest_sp = firmware.last_ram;
  chip_.core().visitor = this;
  chip_.cpu().on_sp_low = Cpu::call<&WatchedChip::stack_is_low>(this);
  chip_.cpu().on_sp_written = Cpu::call<&WatchedChip::stack_pointer_written>(this);
  start();
  if (reset_target(chip_.cpu()) != 0) set_trap(kRestartTrap, 0);
}

void WatchedChip::start() { chip_.cpu().set_pc(reset_target(chip_.cpu())); }

std::uint32_t WatchedChip::return_address(reg::Address at) const {
  std::uint32_t words = 0;
  for (int i = 0; i < spec_.return_address_bytes; ++i)
    words = words << 8 | cpu().data[at + static_cast<unsigned>(i)];
  return 2 * words;
}

void WatchedChip::fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address) {
  if (state_.fault) return;
  state_.fault = Fault{kind, pc, address};
  chip_.cpu().stop();
}

Cycle WatchedChip::last_io() const { return is_asleep() ? cycle() : cpu().state.last_io; }

void WatchedChip::step_singly(bool singly) {
  singly_ = singly;
  chip_.step_singly(singly);
}

void WatchedChip::set_pc(std::uint32_t pc) { chip_.cpu().set_pc(pc / 2); }

void WatchedChip::run_to(Cycle cycle) {
  while (this->cycle() < cycle && !state_.fault && !state_.off && !state_.trapped) {
    const auto why = chip_.run_to(cycle);
    const std::uint32_t last = 2 * cpu().last_pc(), here = pc();
    switch (why) {
      case Chip::Stop::reached:
      case Chip::Stop::sleep:  // never returned by Chip::run_to(), which handles sleep itself
        break;
      case Chip::Stop::off:
        state_.off = true;
        break;
      case Chip::Stop::mark:
        state_.trapped = traps_at(here);
        if (state_.trapped & kRestartTrap) fail(Fault::Kind::restart, 0, 0);
        break;
      case Chip::Stop::bad_read:
        fail(Fault::Kind::bad_read, last, cpu().bad_address());
        break;
      case Chip::Stop::bad_write:
        fail(Fault::Kind::bad_write, last, cpu().bad_address());
        break;
      case Chip::Stop::illegal:
        look_at_code(here);
        break;
      case Chip::Stop::outside:
        fail(Fault::Kind::bad_jump, std::max(here, 2 * cpu().outside_pc()), 0);
        break;
      case Chip::Stop::spm:
        if (data(reg::kSpmcsr) & 1) fail(Fault::Kind::flash_write, last, cpu().pair(30));
        break;
      case Chip::Stop::break_:
        break;  // has no effect, because no debugger is connected to the chip
      case Chip::Stop::stopped:
        return;
    }
    if (singly_) break;
  }
}

void WatchedChip::look_at_code(std::uint32_t pc) {
  const auto flash = cpu().flash();
  const auto word = static_cast<std::uint16_t>(flash[pc] | flash[pc + 1] << 8);
  if (word == kErasedWord || pc >= firmware_.flash.size()) return fail(Fault::Kind::bad_jump, pc, 0);
  fail(Fault::Kind::bad_opcode, pc, word);
}

void WatchedChip::was_reset() {
  const bool too_many = state_.watchdog_resets.add(CycleTime(clock_hz_).of(cycle()));
  state_.last_bite = cycle();
  const std::uint32_t bitten_at = 2 * cpu().last_pc();
  if (has_boot_loader_) {
    chip_.core().at(reg::kMcusr) = 0;
    chip_.cpu().store(chip_.core().chip.at.watchdog, robosim::avr::kWdce | robosim::avr::kWde);
    chip_.cpu().store(chip_.core().chip.at.watchdog, 0);
  }
  state_.own_stack = false;
  state_.handlers_of_stacks.clear();
  chip_.cpu().state.sp_watch = state_.lowest_sp;
  start();
  if (too_many) fail(Fault::Kind::watchdog, bitten_at, 0);
}

std::vector<std::uint8_t> WatchedChip::ram() const {
  const std::vector<std::uint8_t>& data = chip_.cpu().data;
  return {data.begin() + spec().ram_address, data.end()};
}

void WatchedChip::was_browned_out(const std::vector<std::uint8_t>& ram) {
  chip_.core().at(reg::kMcusr) = robosim::avr::kBorf;
  std::copy(ram.begin(), ram.end(), chip_.cpu().data.begin() + spec().ram_address);
}

// --- traps

namespace {

// Returns the first trap at or after `pc`. `traps` must be sorted by pc.
template <class Traps>
auto first_from(Traps& traps, std::uint32_t pc) {
  return std::lower_bound(traps.begin(), traps.end(), pc,
                          [](const auto& trap, std::uint32_t place) { return trap.pc < place; });
}

}  // namespace

std::vector<WatchedChip::TrapPlace>::iterator WatchedChip::trap_from(std::uint32_t pc) {
  return first_from(state_.traps, pc);
}

void WatchedChip::set_trap(Trap trap, std::uint32_t pc) {
  auto place = trap_from(pc);
  if (place == state_.traps.end() || place->pc != pc) place = state_.traps.insert(place, {pc, 0});
  place->traps |= trap;
  chip_.cpu().set_mark(pc / 2, true);
}

void WatchedChip::clear_trap(Trap trap, std::uint32_t pc) {
  const auto place = trap_from(pc);
  if (place == state_.traps.end() || place->pc != pc) return;
  place->traps &= ~static_cast<unsigned>(trap);
  if (place->traps != 0) return;
  chip_.cpu().set_mark(pc / 2, false);
  state_.traps.erase(place);
}

unsigned WatchedChip::traps_at(std::uint32_t pc) const {
  const auto place = first_from(state_.traps, pc);
  return place != state_.traps.end() && place->pc == pc ? place->traps : 0;
}

void WatchedChip::count(LineCounts& lines) {
  lines_ = &lines;
  for (const LineCounts::Begin& begin : lines.begins())
    if (begin.address < firmware_.code_end) set_trap(kLineTrap, begin.address);
}

void WatchedChip::look_for_tearing(const DebugInfo& debug) {
  race_analysis_.emplace(firmware_, debug, chip_, [this](std::uint32_t pc) { set_trap(kTearingTrap, pc); });
  tell_of_handlers();
}

void WatchedChip::show(ChipObserver& observer, std::uint32_t pc) {
  shown_.emplace(pc, &observer);
  set_trap(kObserverTrap, pc);
}

void WatchedChip::show_handlers(ChipObserver& observer) {
  told_of_handlers_.push_back(&observer);
  tell_of_handlers();
}

void WatchedChip::tell_of_handlers() {
  chip_.cpu().on_entered = robosim::avr::Cpu::call<&WatchedChip::handler_entered>(this);
  chip_.cpu().on_left = robosim::avr::Cpu::call<&WatchedChip::handler_left>(this);
}

void WatchedChip::handler_entered() {
  for (ChipObserver* const each : told_of_handlers_) each->entered(vector(), cycle());
  if (race_analysis_) race_analysis_->entered(vector());
}

void WatchedChip::handler_left() {
  for (ChipObserver* const each : told_of_handlers_) each->left();
  if (!race_analysis_) return;
  race_analysis_->left();
  fail_if_torn();
}

bool WatchedChip::fail_if_torn() {
  const auto& found = race_analysis_->found();
  if (!found.empty()) fail(Fault::Kind::torn, found.front().pc, found.front().address);
  return !found.empty();
}

void WatchedChip::restore(const Saved& saved) {
  constexpr unsigned kThatStay = kBreakpoint | kObserverTrap | kTearingTrap;
  const std::vector<TrapPlace> here = std::exchange(state_.traps, {});
  for (const TrapPlace& place : here) chip_.cpu().set_mark(place.pc / 2, false);
  state_ = saved.own;
  for (TrapPlace& place : state_.traps) place.traps &= ~kThatStay;
  std::erase_if(state_.traps, [](const TrapPlace& place) { return place.traps == 0; });
  for (const TrapPlace& place : state_.traps) chip_.cpu().set_mark(place.pc / 2, true);
  for (const TrapPlace& place : here)
    if (place.traps & kThatStay) set_trap(static_cast<Trap>(place.traps & kThatStay), place.pc);
  chip_.restore(saved.chip);
}

bool WatchedChip::visited(std::uint32_t pc, Cycle at) {
  const unsigned traps = traps_at(2 * pc);
  if (traps != kLoopTrap || !rounds_ || !rounds_->is_running()) return others_visited(pc, at, traps);
  rounds_->began(at);
  return true;
}

bool WatchedChip::others_visited(std::uint32_t pc, Cycle at, unsigned traps) {
  const unsigned others = traps & ~unsigned{kLineTrap | kTearingTrap | kObserverTrap};
  if (traps & kLineTrap) lines_->ran(2 * pc);
  if (traps & kObserverTrap)
    for (auto [each, end] = shown_.equal_range(2 * pc); each != end; ++each)
      each->second->visited(2 * pc, at);
  if (traps & kTearingTrap) {
    race_analysis_->visited(2 * pc);
    if (fail_if_torn()) return false;
  }
  if (others == 0) return true;
  if (!rounds_ || !rounds_->is_running() || others != kLoopTrap) return false;
  rounds_->began(at);
  return true;
}

void WatchedChip::left_out(std::uint32_t pc, Cycle first, Cycle period, std::uint64_t count) {
  const unsigned traps = traps_at(2 * pc);
  if (traps & kLoopTrap) rounds_->began(first, period, count);
  if (traps & kLineTrap) lines_->ran(2 * pc, count);
}

// --- the stack

void WatchedChip::set_stack_limit(std::uint16_t limit) { state_.stack_limit = limit; }

void WatchedChip::stack_is_low() {
  state_.pointer_written = 0;
  stack_moved();
}

void WatchedChip::stack_pointer_written() {
  // The stack pointer is complete after the write of its second half. stack_is_low() handles pushes.
  const Cycle now = cycle();
  const bool whole = state_.pointer_written != 0 && now - state_.pointer_written <= kHalvesApart;
  state_.pointer_written = whole ? 0 : now;
  if (!whole) state_.pointer_before = chip_.cpu().state.sp_before;
  chip_.cpu().state.sp_watch = 0xFFFF;
  if (!whole) return;
  const Origin origin = origin_of_stored_value(cpu());
  const bool loaded = is_load(origin.op) && !origin.is_changed;
  const bool computed_from_itself =
      origin.op == Op::in && (origin.address == reg::kSpL || origin.address == reg::kSpH);
  if (loaded) task_changed(state_.pointer_before, sp());
  // A stack that the sketch has set up may begin at stack_limit, or at the byte below stack_limit.
  if (sp() > state_.stack_limit || (computed_from_itself && sp() + 1 >= state_.stack_limit)) {
    state_.own_stack = false;
  } else if (!computed_from_itself) {
    state_.own_stack = true;
    state_.own_variable = variable_of_stack(sp(), loaded);
    state_.own_limit = lowest_of_own_stack();
  }
  stack_moved();
}

/// Returns the lowest address of the stack that the sketch has set up. In an image without symbols (.hex),
/// the size of a stack among the variables is unknown. Such a stack may reach down to the start of RAM.
std::uint16_t WatchedChip::lowest_of_own_stack() const {
  if (state_.own_variable) return static_cast<std::uint16_t>(state_.own_variable->address - kAvrData);
  return sp() > firmware_.globals_end ? firmware_.globals_end : spec_.ram_address;
}

/// Returns the variable that contains a stack. `at` is the stack pointer. The stack pointer of an empty stack
/// may be directly after the variable, at the first byte of another variable.
const Symbol* WatchedChip::variable_of_stack(std::uint16_t at, bool is_in_use) const {
  const Symbol* const here = firmware_.symbols.variable_at(kAvrData + at);
  if (here && (is_in_use || here->address < kAvrData + at)) return here;
  const Symbol* const below = firmware_.symbols.variable_at(kAvrData + at - 1u);
  return below ? below : here;
}

/// Handles a switch from one task to another. A handler may suspend the interrupted task, and continue
/// another task. If the other task had suspended itself outside a handler, it continues by RET instead of
/// RETI.
void WatchedChip::task_changed(std::uint16_t from, std::uint16_t to) {
  if (cpu().open_handlers() > 0) state_.handlers_of_stacks[from] = cpu().open_handlers();
  const auto left = state_.handlers_of_stacks.find(to);
  chip_.cpu().set_open_handlers(left == state_.handlers_of_stacks.end() ? 0 : left->second);
  if (left != state_.handlers_of_stacks.end()) state_.handlers_of_stacks.erase(left);
}

void WatchedChip::stack_moved() {
  const std::uint16_t now = sp();
  if (!state_.own_stack) state_.lowest_sp = std::min(state_.lowest_sp, now);
  chip_.cpu().state.sp_watch =
      static_cast<std::uint16_t>(state_.own_stack ? state_.own_limit - 1 : state_.lowest_sp);
  if (now + 1 < (state_.own_stack ? state_.own_limit : state_.stack_limit))
    fail(Fault::Kind::stack, 2 * cpu().last_pc(), 0);
}

std::vector<std::uint32_t> WatchedChip::last_jumps() const {
  std::vector<std::uint32_t> jumps = cpu().last_jumps();
  for (std::uint32_t& jump : jumps) jump *= 2;
  return jumps;
}

}  // namespace robosim::exec::avr
