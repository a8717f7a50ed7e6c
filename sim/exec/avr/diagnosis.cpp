#include "sim/exec/avr/diagnosis.h"
#include "sim/exec/core/watchdog_resets.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/exec/avr/ubsan_report.h"
#include "sim/exec/elf/demangle.h"

namespace robosim::exec::avr {
namespace {

constexpr std::size_t kMostCalls = 10;
constexpr int kRet = 0x9508, kReti = 0x9518;

bool is_jump(const Fault& fault) {
  return fault.kind == Fault::Kind::bad_jump || fault.kind == Fault::Kind::restart;
}

bool same_place(const SourceLine& a, const SourceLine& b) {
  return a.function == b.function && a.file == b.file && a.line == b.line;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

SourceLine Diagnosis::place_of_calls(const std::vector<Stack::Call>& calls) const {
  for (const Stack::Call& call : calls) {
    const SourceLine where = debug_.place(call.pc);
    if (!where.file.empty()) return where;
  }
  return {};
}

SourceLine Diagnosis::where_now() const {
  const WatchedChip& chip = machine_.chip();
  SourceLine where = debug_.place(chip.pc());
  if (where.file.empty() && chip.in_handler()) where = debug_.place(chip.interrupted_pc());
  return where.file.empty() ? place_of_calls(machine_.stack().open_calls()) : where;
}

SourceLine Diagnosis::sketch_line() const {
  const SourceLine* where = &debug_.sketch_place(machine_.chip().last_pc());
  if (where->file.empty())
    machine_.stack().each_call(0, [&](const Stack::Call& call) {
      where = &debug_.sketch_place(call.pc);
      return !where->file.empty();
    });
  return where->file.empty() ? where_now() : *where;
}

std::optional<std::uint32_t> Diagnosis::jump_target(std::uint32_t pc) const {
  const auto size = static_cast<std::uint32_t>(firmware_.flash.size());
  if (pc + 3 >= size) return std::nullopt;
  const auto word = static_cast<std::uint32_t>(firmware_.word(pc));
  if ((word & 0xFE0E) == 0x940C)
    return 2 * ((word & 0x1F0) << 13 | (word & 1) << 16 | static_cast<std::uint32_t>(firmware_.word(pc + 2)));
  if ((word & 0xF000) != 0xC000) return std::nullopt;
  const std::uint32_t words = word & 0x800 ? word | 0xFFFFF000 : word & 0x7FF;
  return (pc + 2 + 2 * words) % firmware_.chip->flash_bytes;
}

std::optional<int> Diagnosis::unhandled(const Fault& fault) const {
  const WatchedChip& chip = machine_.chip();
  if (fault.kind != Fault::Kind::restart || !chip.in_handler()) return std::nullopt;
  std::optional<std::uint32_t> to = jump_target(chip.vector_address());
  if (to && *to != 0) to = jump_target(*to);
  if (to != 0u) return std::nullopt;
  return chip.vector();
}

std::string Diagnosis::jump_text(const Fault& fault) const {
  if (const auto vector = unhandled(fault))
    return fmt::format(
        "interrupt {} was triggered, but has no ISR(...): is its name misspelt, or is an enable bit set "
        "by mistake? The sketch would restart",
        *vector);
  const std::string target =
      fault.kind == Fault::Kind::restart
          ? "address 0, where a reset begins: the sketch would restart"
          : fmt::format("address 0x{:04X}, {}", fault.pc,
                        fault.pc < firmware_.chip->flash_bytes ? "where there is no code"
                                                               : "after the end of the flash");
  const auto calls = machine_.stack().open_calls();
  if (!calls.empty() && calls[0].by_pointer) return "call through a wrong function pointer to " + target;
  const auto jumps = machine_.chip().last_jumps();
  const int last = jumps.empty() ? 0 : firmware_.word(jumps[0]);
  if ((last == kRet || last == kReti) && machine_.stack().last_return() == fault.pc)
    return "return to " + target + " (the return address on the stack was overwritten)";
  return "jump to " + target;
}

std::string Diagnosis::overflow_text() const {
  const WatchedChip& chip = machine_.chip();
  if (!chip.has_own_stack())
    return fmt::format(
        "stack overflow: the stack has outgrown the {} bytes of RAM that variables and heap leave free",
        machine_.stack().room_bytes());
  const Symbol* const variable = chip.own_stack_variable();
  if (!variable && chip.sp() < firmware_.chip->ram_address)
    return "stack overflow: a stack that the sketch has set up has outgrown the RAM";
  if (!variable)
    return "stack overflow: a stack that the sketch has allocated in the heap has outgrown its block";
  return fmt::format("stack overflow: the stack that the sketch has placed in {} has outgrown its {} bytes",
                     demangle(variable->name), variable->size);
}

std::string Diagnosis::reason(const Fault& fault) const {
  if (fault.kind == Fault::Kind::stack ||
      (fault.kind != Fault::Kind::watchdog && machine_.stack().has_overflown()))
    return overflow_text();
  switch (fault.kind) {
    case Fault::Kind::bad_read:
      return fmt::format("read of address 0x{:04X}, where the chip has no memory (its RAM ends at 0x{:04X})",
                         fault.address, firmware_.last_ram);
    case Fault::Kind::bad_write:
      return fmt::format("write to address 0x{:04X}, where the chip has no memory (its RAM ends at 0x{:04X})",
                         fault.address, firmware_.last_ram);
    case Fault::Kind::bad_opcode:
      return fmt::format("illegal instruction 0x{:04X} at flash address 0x{:04X}", fault.address, fault.pc);
    case Fault::Kind::flash_write:
      return fmt::format("write to the sketch's own flash at 0x{:04X} (instruction spm)", fault.address);
    case Fault::Kind::watchdog:
      return WatchdogResets::reason();
    case Fault::Kind::torn: {
      const RaceAnalysis::Found& found = machine_.chip().race_analysis()->found().front();
      return torn_text(found, debug_, machine_.chip().clock_hz()) + "; " + fix_of(found.kind);
    }
    default:
      return jump_text(fault);
  }
}

std::vector<SourceLine> Diagnosis::call_chain(std::uint32_t pc) const {
  std::vector<SourceLine> chain;
  const auto add = [&](std::uint32_t at) {
    std::vector<SourceLine> frames = debug_.frames(at);
    const Symbol* function = frames.empty() ? firmware_.function_at(at) : nullptr;
    if (function) frames.push_back({function->name, "", 0});
    for (const SourceLine& frame : frames)
      if (!frame.function.starts_with(kCheckPrefix) && chain.size() < kMostCalls &&
          (chain.empty() || !same_place(chain.back(), frame)))
        chain.push_back(frame);
  };
  add(pc);
  for (const Stack::Call& call : machine_.stack().open_calls()) add(call.pc);
  return chain;
}

std::string Diagnosis::registers() const {
  const WatchedChip& chip = machine_.chip();
  std::string sreg;
  for (int bit = 7; bit >= 0; --bit) sreg += chip.status() >> bit & 1 ? "CZNVSHTI"[bit] : '-';
  std::string text = fmt::format("PC 0x{:04X}  SP 0x{:04X}  SREG {}", chip.pc(), chip.sp(), sreg);
  for (reg::Address r = 0; r < 32; ++r)
    text += fmt::format("{}r{} {:02X}", r % 16 == 0 ? "\n" : "  ", r, chip.data(r));
  return text;
}

SourceLine Diagnosis::place_of_check(const Undefined& found) const {
  const auto calls = machine_.stack().open_calls();
  SourceLine best;
  for (const Stack::Call& call : calls) {
    for (SourceLine frame : debug_.frames(call.pc)) {
      if (is_core_file(frame.file) || frame.function.starts_with(kCheckPrefix)) continue;
      if (found.file.empty()) return frame;
      // Uses the line that gcc passes to the check, because the optimiser may have moved the check's call.
      if (best.file.empty()) best = {frame.function, file_name(found.file), found.line};
      if (file_name(frame.file) != file_name(found.file)) continue;
      frame.line = found.line;
      return frame;
    }
    if (!best.file.empty()) return best;
  }
  return {"", file_name(found.file), found.line};
}

Crash Diagnosis::crash(const Fault& fault) const {
  Crash crash;
  crash.calls = call_chain(fault.pc);
  crash.registers = registers();
  if (const auto found = failed_check(firmware_, machine_.chip(), fault)) {
    crash.check = found->check;
    crash.reason = found->reason;
    crash.where = place_of_check(*found);
    std::erase_if(crash.calls, [](const SourceLine& call) { return call.file.starts_with("robosim/"); });
    return crash;
  }
  crash.reason = reason(fault);
  if (fault.kind == Fault::Kind::torn)
    crash.check = check_of(machine_.chip().race_analysis()->found().front().kind);
  const Stack& stack = machine_.stack();
  if (!is_jump(fault)) crash.where = debug_.place(fault.pc);
  // After a jump to an invalid address, reports the instruction that jumped there, or else an earlier jump.
  if (is_jump(fault))
    for (const std::uint32_t pc : machine_.chip().last_jumps())
      if (crash.where.file.empty()) crash.where = debug_.place(pc);
  if (crash.where.file.empty() && machine_.chip().in_handler())
    crash.where = debug_.place(machine_.chip().interrupted_pc());
  if (crash.where.file.empty()) crash.where = place_of_calls(stack.open_calls());
  return crash;
}

std::string Diagnosis::api_call(std::uint32_t pc) const {
  const std::vector<SourceLine> frames = debug_.frames(pc);
  std::string name;
  for (const SourceLine& frame : frames) {
    if (!is_core_file(frame.file)) break;
    name = frame.function;
  }
  return name.empty() || name == "main" || name.starts_with("__") ? "" : name + "()";
}

std::string Diagnosis::api_call_now() const {
  if (machine_.chip().in_handler()) return "";
  std::string name;
  for (const SourceLine& frame : call_chain(machine_.chip().pc())) {
    if (!is_core_file(frame.file)) return name.empty() || frame.file.empty() ? "" : name + "()";
    name = frame.function;
  }
  return "";
}

std::string Diagnosis::stopped_by() const {
  const WatchedChip& chip = machine_.chip();
  if (chip.is_off()) return "sleeping with interrupts off";
  const auto stop = firmware_.find("__stop_program");
  return stop && chip.pc() == *stop ? "exit()" : "";
}

Activity Diagnosis::activity() const {
  const WatchedChip& chip = machine_.chip();
  Activity activity;
  activity.call = api_call(chip.last_io_pc());
  if (activity.call.starts_with("digitalRead") || activity.call.starts_with("pulseIn"))
    activity.pin = machine_.adapter().last_read();
  else if (const std::string call = api_call_now(); !call.empty())
    activity.call = call;
  const Cycle second = machine_.chip().clock_hz();
  if (chip.cycle() - machine_.adapter().last_read_at() <= second)
    activity.polled = machine_.adapter().only_read();
  activity.where = where_now();
  activity.stopped_by = stopped_by();
  return activity;
}

}  // namespace robosim::exec::avr
