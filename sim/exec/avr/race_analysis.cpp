#include "sim/exec/avr/race_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "sim/base/elf/avr_addresses.h"
#include "sim/exec/avr/data_flow.h"
#include "sim/exec/avr/demangle.h"
#include "sim/mcu/avr/instruction_table.h"
#include "sim/result/detector_names.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Address;
using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Cpu;
using robosim::avr::Cycle;
using robosim::avr::Instruction;
using robosim::avr::Interrupts;
using robosim::avr::Op;

constexpr std::uint32_t kLargestNumber = 8;
// Largest distances in words: from the first to the last instruction of an access, and from an access to
// another read of the number.
constexpr std::uint32_t kWordsOfAccess = 16, kWordsOfSecondLook = 48;
constexpr int kMostOfHandler = 5000;  // longest examined handler, in instructions
constexpr int kZeroRegister = 1;      // register that always contains 0 in code of avr-gcc
constexpr const char* kInterruptsOff = "with interrupts off (noInterrupts(), ATOMIC_BLOCK)";
constexpr std::int64_t kSoon_hz = 20'000;

bool is_sketchs(const DebugInfo& debug, std::uint32_t pc) {
  const auto frames = debug.frames(pc);
  return std::any_of(frames.begin(), frames.end(),
                     [](const SourceLine& frame) { return !is_core_file(frame.file); });
}

}  // namespace

RaceAnalysis::RaceAnalysis(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
                           std::function<void(std::uint32_t pc)> show)
    : firmware_(firmware),
      chip_(chip),
      show_(std::move(show)),
      alone_(chip.cpu().chip(), chip.cpu().flash(), chip.cpu().last_ram()) {
  for (const auto& [address, size, path] : debug.numbers()) {
    if (!path.empty()) continue;
    const Symbol* const symbol = address >= kAvrData ? firmware.symbols.variable_at(address) : nullptr;
    if (!symbol || symbol->address != address || symbol->size < 1 || symbol->size > kLargestNumber) continue;
    numbers_.push_back({symbol, static_cast<Address>(address - kAvrData)});
  }
  find_accesses(debug);
  if (accesses_.empty()) return;
  keep_accessed_numbers();
  for (int vector = 1; vector < chip_.cpu().chip().vectors; ++vector)
    if (may_write_numbers(vector)) writers_ |= Interrupts::bit(vector);
}

/// Returns whether a handler, or a function that the handler calls, may store to one of the numbers. Stores
/// through pointers, and calls or jumps through pointers, count as stores to a number.
bool RaceAnalysis::may_write_numbers(int vector) const {
  const Cpu& cpu = chip_.cpu();
  std::vector<bool> seen(firmware_.code_end / 2 + 2);
  std::vector<std::uint32_t> next = {cpu.entry_of(vector)};
  while (!next.empty()) {
    const std::uint32_t pc = next.back();
    next.pop_back();
    if (2 * pc >= firmware_.code_end) return true;
    if (seen[pc]) continue;
    seen[pc] = true;
    const Instruction& i = cpu.instruction(pc);
    const Control control = control_of(i.op);
    if (robosim::avr::stores_by_pointer(i.op) || control == Control::indirect_jump ||
        control == Control::indirect_call || (i.op == Op::sts && touched(i)))
      return true;
    add_next(cpu, pc, true, next);
  }
  return false;
}

void RaceAnalysis::keep_accessed_numbers() {
  std::vector<Number> kept;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    bool is_accessed = false;
    for (Access& access : accesses_) {
      if (access.number != n) continue;
      access.number = kept.size();
      is_accessed = true;
    }
    if (is_accessed) kept.push_back(numbers_[n]);
  }
  numbers_ = std::move(kept);
}

std::optional<std::size_t> RaceAnalysis::touched(const Instruction& i) const {
  if (i.op != Op::lds && i.op != Op::sts) return std::nullopt;
  for (std::size_t n = 0; n < numbers_.size(); ++n)
    if (static_cast<std::uint32_t>(i.k - numbers_[n].begin) < numbers_[n].symbol->size) return n;
  return std::nullopt;
}

void RaceAnalysis::find_accesses(const DebugInfo& debug) {
  const Cpu& cpu = chip_.cpu();
  for (std::uint32_t pc = 0; 2 * pc < firmware_.code_end; pc += cpu.instruction(pc).words) {
    if (const auto number = touched(cpu.instruction(pc)))
      numbers_[*number].symbol->size == 1 ? add_update(pc, debug) : add_group(pc, debug);
  }
  const std::vector<bool> off = without_interrupts(cpu, firmware_.code_end);
  const std::vector<bool> handlers = of_handlers(cpu, firmware_.code_end);
  std::erase_if(accesses_,
                [&](const Access& access) { return off[access.pc / 2] || handlers[access.pc / 2]; });
  std::sort(accesses_.begin(), accesses_.end(), [](const Access& a, const Access& b) { return a.pc < b.pc; });
  const auto same = std::unique(accesses_.begin(), accesses_.end(),
                                [](const Access& a, const Access& b) { return a.pc == b.pc; });
  accesses_.erase(same, accesses_.end());
}

/// Adds an access to a number of several bytes. The instruction at word address `pc` must access one byte of
/// the number, and a later instruction another byte.
void RaceAnalysis::add_group(std::uint32_t pc, const DebugInfo& debug) {
  const Cpu& cpu = chip_.cpu();
  const Instruction& first = cpu.instruction(pc);
  const std::size_t number = *touched(first);
  for (std::uint32_t next = pc + first.words; next < pc + kWordsOfAccess;
       next += cpu.instruction(next).words) {
    const Instruction& i = cpu.instruction(next);
    if (control_of(i.op) != Control::straight) return;
    if (touched(i) != number) continue;
    if (i.op != first.op || i.k == first.k) return;
    if (!is_sketchs(debug, 2 * next) || (first.op == Op::lds && is_read_again(pc, number))) return;
    accesses_.push_back({2 * next, number, first.op == Op::sts ? AccessKind::writes : AccessKind::reads});
    return;
  }
}

/// Adds an update if the byte that is read at word address `pc` is changed and written back.
void RaceAnalysis::add_update(std::uint32_t pc, const DebugInfo& debug) {
  const Cpu& cpu = chip_.cpu();
  const Instruction& first = cpu.instruction(pc);
  if (first.op != Op::lds) return;
  ValueFlow trail(first.a);
  for (std::uint32_t next = pc + first.words; next < pc + kWordsOfAccess;
       next += cpu.instruction(next).words) {
    const Instruction& i = cpu.instruction(next);
    if (control_of(i.op) != Control::straight) return;
    if (i.op != Op::sts || i.k != first.k) {
      trail.follow(i);
      continue;
    }
    if (trail.is_changed(i.a) && is_sketchs(debug, 2 * next))
      accesses_.push_back({2 * next, *touched(first), AccessKind::writes_back});
    return;
  }
}

/// Returns whether the function reads the number twice near `pc`, compares two values, and jumps back. Such a
/// loop reads the number until two reads agree.
bool RaceAnalysis::is_read_again(std::uint32_t pc, std::size_t number) const {
  const Cpu& cpu = chip_.cpu();
  std::uint32_t begin = pc > kWordsOfSecondLook ? pc - kWordsOfSecondLook : 0;
  std::uint32_t end = std::min(pc + kWordsOfSecondLook, firmware_.code_end / 2);
  if (const Symbol* const function = firmware_.function_at(2 * pc); function && function->size > 0) {
    begin = std::max(begin, function->address / 2);
    end = std::min(end, (function->address + function->size) / 2);
  }
  int first_bytes = 0;
  bool compares = false;
  for (std::uint32_t at = begin; at < end; ++at) {
    const Instruction& i = cpu.instruction(at);
    if (i.op == Op::lds && i.k == numbers_[number].begin) ++first_bytes;
    // Ignores comparisons with r1, by which avr-gcc 14 tests a register for 0.
    const bool compares_two =
        (i.op == Op::cp || i.op == Op::cpc) && i.a != kZeroRegister && i.b != kZeroRegister;
    compares = compares || (compares_two && first_bytes > 0);
    const bool back = (i.op == Op::brbc || i.op == Op::brbs || i.op == Op::rjmp) && i.k < 0;
    if (back && compares && first_bytes >= 2) return true;
  }
  return false;
}

std::uint64_t RaceAnalysis::value_of(const Number& number, const std::vector<std::uint8_t>& data) const {
  std::uint64_t value = 0;
  for (std::uint32_t byte = 0; byte < number.symbol->size; ++byte)
    value |= std::uint64_t{data[number.begin + byte]} << (8 * byte);
  return value;
}

void RaceAnalysis::visited(std::uint32_t pc) {
  if (found_) return;
  const Cpu& cpu = chip_.cpu();
  const auto access = std::lower_bound(accesses_.begin(), accesses_.end(), pc,
                                       [](const Access& a, std::uint32_t place) { return a.pc < place; });
  if (access != accesses_.end() && access->pc == pc && cpu.open_handlers() == 0 && cpu.interrupts_enabled())
    touch(static_cast<std::size_t>(access - accesses_.begin()));
}

Cycle RaceAnalysis::soon() const { return static_cast<Cycle>(chip_.core().clock_hz / kSoon_hz); }

void RaceAnalysis::touch(std::size_t access) {
  const std::size_t number = accesses_[access].number;
  std::erase_if(armed_, [&](const Armed& armed) { return accesses_[armed.access].number == number; });
  if (chip_.core().events.next_urgent() > chip_.cycle() + soon()) return;  // no handler will run soon
  const std::uint64_t vectors = chip_.may_interrupt();
  if (vectors) armed_.push_back({access, vectors, chip_.cycle(), chip_.cpu().data, chip_.cpu().state});
}

/// Returns the address at which the handler would have changed the number if it had run at the access.
/// Returns nothing if the handler would not have changed the number.
std::optional<std::uint32_t> RaceAnalysis::would_have_changed(const Armed& armed, int vector) {
  const Number& number = numbers_[accesses_[armed.access].number];
  alone_.data = armed.data;
  alone_.state = armed.state;
  alone_.state.sp_watch = 0;
  alone_.state.passing = ~0u;
  const std::uint64_t before = value_of(number, alone_.data);
  alone_.enter(vector);
  for (int i = 0; i < kMostOfHandler && alone_.open_handlers() > 0; ++i) {
    const std::uint32_t pc = alone_.pc();
    if (alone_.run(alone_.cycle() + 1) != robosim::avr::Cpu::Stop::reached) return std::nullopt;
    if (value_of(number, alone_.data) != before) return 2 * pc;
  }
  return std::nullopt;
}

void RaceAnalysis::entered(int vector) {
  if (found_ || chip_.cpu().open_handlers() != 1 || !(writers_ & Interrupts::bit(vector))) return;
  vector_ = vector;
  for (Number& number : numbers_) number.before = value_of(number, chip_.cpu().data);
}

void RaceAnalysis::left() {
  if (found_ || chip_.cpu().open_handlers() != 0) return;
  const int vector = std::exchange(vector_, 0);
  if (vector == 0) return;
  const Cycle began = chip_.cpu().state.handler_began;
  for (std::size_t n = 0; n < numbers_.size(); ++n) note_change(n);
  for (const Armed& armed : armed_) {
    const Access& access = accesses_[armed.access];
    const Number& number = numbers_[access.number];
    const bool changes = number.before != value_of(number, chip_.cpu().data);
    const bool many = access.kind == AccessKind::writes_back ||
                      (number.changed >> (std::countr_zero(number.changed) / 8 * 8)) > 0xFF;
    if (!(armed.vectors >> vector & 1) || !changes || !many || began < armed.at || began - armed.at > soon())
      continue;
    const auto handler_pc = would_have_changed(armed, vector);
    if (!handler_pc) continue;
    found_ = Found{number.symbol, access.kind, access.pc, *handler_pc, began - armed.at};
    return;
  }
}

void RaceAnalysis::note_change(std::size_t number) {
  Number& here = numbers_[number];
  const std::uint64_t changed = here.before ^ value_of(here, chip_.cpu().data);
  if (changed && !here.changed)
    for (const Access& access : accesses_)
      if (access.number == number) show_(access.pc);
  here.changed |= changed;
}

const char* check_of(RaceAnalysis::AccessKind kind) {
  switch (kind) {
    case RaceAnalysis::AccessKind::reads:
      return result::detector("torn_read");
    case RaceAnalysis::AccessKind::writes:
      return result::detector("torn_write");
    case RaceAnalysis::AccessKind::writes_back:
      return result::detector("lost_update");
  }
  return "";
}

std::string fix_of(RaceAnalysis::AccessKind kind) {
  const char* const what = kind == RaceAnalysis::AccessKind::reads    ? "copy"
                           : kind == RaceAnalysis::AccessKind::writes ? "write"
                                                                      : "change";
  return fmt::format("{} it {}", what, kInterruptsOff);
}

std::string torn_text(const RaceAnalysis::Found& found, const DebugInfo& debug, std::uint32_t clock_hz) {
  const double later_us = 1e6 * static_cast<double>(found.later) / clock_hz;
  const SourceLine at = debug.place(found.handler_pc);
  const std::string handler =
      at.file.empty() ? "a handler" : fmt::format("the handler at {}:{}", at.file, at.line);
  if (found.kind == RaceAnalysis::AccessKind::writes_back)
    return fmt::format(
        "lost update of {}, which is read, changed and written back: {} changes it in an interrupt; "
        "{:.1f} µs earlier, that change would have been lost",
        demangle(found.number->name), handler, later_us);
  const bool writes = found.kind == RaceAnalysis::AccessKind::writes;
  return fmt::format(
      "torn {} of {}, whose {} bytes the chip {} one by one: {} changes them in an interrupt; {:.0f} µs "
      "earlier, old and new bytes would have been mixed",
      writes ? "write" : "read", demangle(found.number->name), found.number->size,
      writes ? "writes" : "reads", handler, later_us);
}

}  // namespace robosim::exec::avr
