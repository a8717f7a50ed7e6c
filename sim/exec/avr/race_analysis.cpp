#include "sim/exec/avr/race_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "sim/exec/avr/data_flow.h"
#include "sim/exec/elf/demangle.h"
#include "sim/mcu/avr/instruction_effects.h"
#include "sim/mcu/avr/instruction_table.h"
#include "sim/result/detector_names.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Cpu;
using robosim::avr::Cycle;
using robosim::avr::Instruction;
using robosim::avr::Interrupts;
using robosim::avr::Op;

constexpr int kMostOfHandler = 5000;  // longest examined handler, in instructions
constexpr std::size_t kMostFound = 8;
constexpr std::uint32_t kCompared = 64;  // bytes that are compared at a time
constexpr const char* kInterruptsOff = "with interrupts off (noInterrupts(), ATOMIC_BLOCK)";
constexpr std::int64_t kSoon_hz = 20'000;

}  // namespace

RaceAnalysis::RaceAnalysis(const Firmware& firmware, const DebugInfo& debug, const robosim::avr::Chip& chip,
                           std::function<void(std::uint32_t pc)> show)
    : firmware_(firmware),
      debug_(debug),
      chip_(chip),
      show_(std::move(show)),
      numbers_(firmware, debug, chip.cpu().data.size()),
      alone_(chip.cpu().chip(), chip.cpu().flash(), chip.cpu().last_ram()),
      changed_(numbers_.all().size()) {
  if (numbers_.all().empty()) return;
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
        control == Control::indirect_call ||
        (i.op == Op::sts && numbers_.at(static_cast<std::uint32_t>(i.k))))
      return true;
    add_next(cpu, pc, true, next);
  }
  return false;
}

bool RaceAnalysis::is_done() const { return found_.size() >= kMostFound; }

std::uint64_t RaceAnalysis::value_of(std::size_t index, const std::uint8_t* data) const {
  const SharedNumbers::Number& here = number(index);
  std::uint64_t value = 0;
  for (std::uint32_t byte = 0; byte < here.size; ++byte)
    value |= std::uint64_t{data[here.begin + byte]} << (8 * byte);
  return value;
}

/// Returns whether the changes by handlers can tear an access to the number. If the number has several bytes,
/// handlers must have changed at least two of them.
bool RaceAnalysis::can_be_torn(std::size_t index) const {
  const std::uint64_t changed = changed_[index];
  if (changed == 0) return false;
  return number(index).size == 1 || (changed >> (std::countr_zero(changed) / 8 * 8)) > 0xFF;
}

/// Returns the number that contains this address and the address of an earlier access. Returns nothing if
/// there is no such number, or if handlers change a guard of the access.
std::optional<std::size_t> RaceAnalysis::number_of(const RaceCandidate& access, std::uint32_t address) const {
  const auto index = numbers_.at(address);
  if (!index || (number(*index).size == 1) != (access.kind == AccessKind::writes_back)) return std::nullopt;
  const auto at = [&](int distance) { return numbers_.at(address + static_cast<std::uint32_t>(distance)); };
  const bool is_same = access.number || std::any_of(access.earlier.begin(), access.earlier.end(),
                                                    [&](int distance) { return at(distance) == index; });
  const bool is_guarded = std::any_of(access.guards.begin(), access.guards.end(), [&](int distance) {
    const auto guard = at(distance);
    return guard && guard != index && changed_[*guard] != 0;
  });
  return is_same && !is_guarded ? index : std::nullopt;
}

void RaceAnalysis::visited(std::uint32_t pc) {
  if (is_done() || !accesses_) return;
  const Cpu& cpu = chip_.cpu();
  const auto access =
      std::lower_bound(accesses_->begin(), accesses_->end(), pc,
                       [](const RaceCandidate& a, std::uint32_t place) { return a.pc < place; });
  if (access != accesses_->end() && access->pc == pc && cpu.open_handlers() == 0 && cpu.interrupts_enabled())
    touch(*access);
}

Cycle RaceAnalysis::soon() const { return static_cast<Cycle>(chip_.core().clock_hz / kSoon_hz); }

void RaceAnalysis::touch(const RaceCandidate& access) {
  const Cpu& cpu = chip_.cpu();
  const Instruction& instruction = cpu.instruction(access.pc / 2);
  const auto index = number_of(access, robosim::avr::effects_of(instruction, cpu).address);
  if (!index || changed_[*index] == 0) return;
  std::erase_if(armed_, [&](const Armed& armed) {
    return armed.number == *index || armed.at + soon() < chip_.cycle();
  });
  if (chip_.core().events.next_urgent() > chip_.cycle() + soon()) return;  // no handler will run soon
  const std::uint64_t vectors = chip_.may_interrupt();
  if (vectors) armed_.push_back({&access, *index, vectors, chip_.cycle(), cpu.data, cpu.state});
}

/// Returns how the handler would have changed the number if it had run at the access. Returns nothing if the
/// handler would not have changed the number.
std::optional<RaceAnalysis::Change> RaceAnalysis::would_have_changed(const Armed& armed, int vector) {
  alone_.data = armed.data;
  alone_.state = armed.state;
  alone_.state.sp_watch = 0;
  alone_.state.passing = ~0u;
  const std::uint64_t before = value_of(armed.number, alone_.data.data());
  alone_.enter(vector);
  Change change{0, {2 * alone_.pc()}};
  for (int i = 0; i < kMostOfHandler && alone_.open_handlers() > 0; ++i) {
    change.pc = 2 * alone_.pc();
    const Control control = control_of(alone_.instruction(alone_.pc()).op);
    if (alone_.run(alone_.cycle() + 1) != robosim::avr::Cpu::Stop::reached) return std::nullopt;
    if (value_of(armed.number, alone_.data.data()) != before) return change;
    if (control != Control::straight && control != Control::branch && control != Control::skip)
      change.entered.push_back(2 * alone_.pc());
  }
  return std::nullopt;
}

void RaceAnalysis::entered(int vector) {
  if (is_done() || chip_.cpu().open_handlers() != 1 || !(writers_ & Interrupts::bit(vector))) return;
  vector_ = vector;
  const auto data = chip_.cpu().data.begin();
  before_.resize(numbers_.end());
  std::copy(data + numbers_.begin(), data + numbers_.end(), before_.begin() + numbers_.begin());
}

void RaceAnalysis::left() {
  if (is_done() || chip_.cpu().open_handlers() != 0) return;
  const int vector = std::exchange(vector_, 0);
  if (vector == 0) return;
  note_changes();
  for (const Armed& armed : armed_) examine(armed, vector);
}

/// Reports the access if the handler that has just returned could have torn it.
void RaceAnalysis::examine(const Armed& armed, int vector) {
  const RaceCandidate& access = *armed.access;
  const Cycle began = chip_.cpu().state.handler_began;
  const bool changes =
      value_of(armed.number, before_.data()) != value_of(armed.number, chip_.cpu().data.data());
  if (!(armed.vectors >> vector & 1) || !changes || !can_be_torn(armed.number) || began < armed.at ||
      began - armed.at > soon() || is_done())
    return;
  const SharedNumbers::Number& here = number(armed.number);
  const bool is_known = std::any_of(found_.begin(), found_.end(), [&](const Found& found) {
    return found.address == here.begin || found.pc == access.pc;
  });
  if (is_known) return;
  const auto change = would_have_changed(armed, vector);
  if (!change) return;
  found_.push_back({demangle(here.variable->name) + here.path, here.begin, here.size, access.kind, access.pc,
                    change->pc, handler_of(*change), began - armed.at});
}

/// Returns the name of the first user function that a handler of the Arduino core called. Returns "" if the
/// user wrote the handler itself (ISR).
std::string RaceAnalysis::handler_of(const Change& change) const {
  for (const std::uint32_t pc : change.entered) {
    const std::vector<SourceLine> frames = debug_.frames(pc);
    const auto outermost = std::find_if(frames.rbegin(), frames.rend(),
                                        [](const SourceLine& frame) { return !is_core_file(frame.file); });
    if (outermost == frames.rend()) continue;
    return outermost->function.starts_with("__vector_") ? "" : outermost->function;
  }
  return "";
}

/// Notes the numbers that the handler has changed.
void RaceAnalysis::note_changes() {
  const std::uint8_t* const data = chip_.cpu().data.data();
  const auto is_same = [&](std::uint32_t begin, std::uint32_t end) {
    return std::memcmp(data + begin, before_.data() + begin, end - begin) == 0;
  };
  if (is_same(numbers_.begin(), numbers_.end())) return;
  for (std::uint32_t begin = numbers_.begin(), end = begin; begin < numbers_.end(); begin = end) {
    end = std::min(begin + kCompared, numbers_.end());
    if (is_same(begin, end)) continue;
    std::optional<std::size_t> last;
    for (std::uint32_t address = begin; address < end; ++address) {
      const auto index = data[address] != before_[address] ? numbers_.at(address) : std::nullopt;
      if (index && index != last) note_change(*index);
      if (index) last = index;
    }
  }
}

void RaceAnalysis::note_change(std::size_t index) {
  if (!accesses_) accesses_ = find_race_candidates(firmware_, debug_, chip_.cpu(), numbers_);
  const bool is_new = changed_[index] == 0;
  changed_[index] |= value_of(index, before_.data()) ^ value_of(index, chip_.cpu().data.data());
  if (is_new) show_if([&](const RaceCandidate& access) { return access.number == index; });
  const bool is_byte = number(index).size == 1;
  bool& shown = is_byte ? shows_updates_ : shows_groups_;
  if (shown || !can_be_torn(index)) return;
  shown = true;  // an access through a pointer may concern any number
  show_if([&](const RaceCandidate& access) {
    return !access.number && (access.kind == AccessKind::writes_back) == is_byte;
  });
}

template <class Wanted>
void RaceAnalysis::show_if(Wanted wanted) const {
  for (const RaceCandidate& access : *accesses_)
    if (wanted(access)) show_(access.pc);
}

const char* check_of(AccessKind kind) {
  switch (kind) {
    case AccessKind::reads:
      return result::detector("torn_read");
    case AccessKind::writes:
      return result::detector("torn_write");
    case AccessKind::writes_back:
      return result::detector("lost_update");
  }
  return "";
}

std::string fix_of(AccessKind kind) {
  const char* const what = kind == AccessKind::reads    ? "copy"
                           : kind == AccessKind::writes ? "write"
                                                        : "change";
  return fmt::format("{} it {}", what, kInterruptsOff);
}

std::string torn_text(const RaceAnalysis::Found& found, const DebugInfo& debug, std::uint32_t clock_hz) {
  const double later_us = 1e6 * static_cast<double>(found.later) / clock_hz;
  const SourceLine at = debug.place(found.handler_pc);
  const bool is_called = !found.handler.empty() && found.handler != at.function;
  const std::string handler = at.file.empty() ? "a handler"
                              : is_called ? fmt::format("{} at {}:{}, called by the handler {},", at.function,
                                                        at.file, at.line, found.handler)
                                          : fmt::format("the handler at {}:{}", at.file, at.line);
  if (found.kind == AccessKind::writes_back)
    return fmt::format(
        "lost update of {}, which is read, changed and written back: {} changes it in an interrupt; "
        "if the interrupt had come {:.1f} µs earlier, that change would have been lost",
        found.number, handler, later_us);
  const bool writes = found.kind == AccessKind::writes;
  return fmt::format(
      "torn {} of {}, whose {} bytes the chip {} one by one: {} changes them in an interrupt; if the "
      "interrupt had come {:.0f} µs earlier, old and new bytes would have been mixed",
      writes ? "write" : "read", found.number, found.size, writes ? "writes" : "reads", handler, later_us);
}

}  // namespace robosim::exec::avr
