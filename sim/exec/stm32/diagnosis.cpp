#include "sim/exec/stm32/diagnosis.h"
#include "sim/exec/core/watchdog_resets.h"

#include <fmt/format.h>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::size_t kMostCalls = 10;

bool is_jump(const Fault& fault) {
  return fault.kind == Fault::Kind::bad_jump || fault.kind == Fault::Kind::exception_return;
}

bool same_place(const SourceLine& a, const SourceLine& b) {
  return a.function == b.function && a.file == b.file && a.line == b.line;
}

}  // namespace

SourceLine Diagnosis::place_of(const std::vector<std::uint32_t>& calls) const {
  for (const std::uint32_t call : calls) {
    const SourceLine where = debug_.place(call);
    if (!where.file.empty()) return where;
  }
  return {};
}

SourceLine Diagnosis::where_now() const {
  SourceLine where = debug_.place(cpu_.pc());
  if (where.file.empty() && cpu_.in_handler()) where = debug_.place(cpu_.interrupted_pc());
  return where.file.empty() ? place_of(machine_.open_calls()) : where;
}

std::string Diagnosis::access_text(const char* kind, std::uint32_t address) const {
  constexpr std::uint32_t kTwice = 2 * kStm32f103c8.flash_bytes;  // many STM32F103C8 really have this much
  if (address >= kFlash && address < kFlash + kTwice)
    return fmt::format("{} address 0x{:08X}, after the {} KB of flash that the chip's data sheet guarantees",
                       kind, address, kStm32f103c8.flash_bytes / 1024);
  return fmt::format("{} address 0x{:08X}{}, where the chip has no memory (its RAM ends at 0x{:08X})", kind,
                     address, address < 256 ? " (null pointer)" : "", kRam + kRamBytes - 1);
}

std::string Diagnosis::jump_text(const Fault& fault) const {
  const auto jumps = cpu_.last_jumps();
  const unsigned op = jumps.empty() ? 0 : firmware_.half(jumps[0]);
  const std::string target = fmt::format("address 0x{:08X}, where there is no code", fault.pc);
  if ((op & 0xFF87) == 0x4780) return "call through a wrong function pointer to " + target;
  const bool pops = (op & 0xFF00) == 0xBD00 || op == 0xE8BD || op == 0x4770;
  if (pops) return "return to " + target + " (the return address on the stack was overwritten)";
  return "jump to " + target;
}

std::string Diagnosis::reason(const Fault& fault) const {
  if (fault.kind == Fault::Kind::stack)
    return fmt::format(
        "stack overflow: the stack has outgrown the {} bytes of RAM that variables and heap leave free",
        kRam + kRamBytes - cpu_.stack_limit());
  switch (fault.kind) {
    case Fault::Kind::bad_read:
      return access_text("read of", fault.address);
    case Fault::Kind::bad_write:
      return access_text("write to", fault.address);
    case Fault::Kind::flash_write:
      if (fault.address < kFlash)
        return fmt::format("write to address 0x{:08X} (null pointer), where flash is mapped", fault.address);
      return fmt::format("write to flash at 0x{:08X}", fault.address);
    case Fault::Kind::bad_opcode:
      return fmt::format("illegal instruction 0x{:X} at 0x{:08X}", fault.address, fault.pc);
    case Fault::Kind::breakpoint:
      return fmt::format("breakpoint instruction at 0x{:08X} without a debugger", fault.pc);
    case Fault::Kind::division:
      return "division by zero, which is a fault because the sketch has set DIV_0_TRP in SCB_CCR";
    case Fault::Kind::unhandled:
      return fmt::format("exception {} without a handler", fault.address);
    case Fault::Kind::unmodelled: {
      const Unmodelled& access = *machine_.bus().unmodelled();
      return access.write ? fmt::format("write of 0x{:X} to {}, which Robosim does not model", access.value,
                                        access.what)
                          : fmt::format("read of {}, which Robosim does not model", access.what);
    }
    case Fault::Kind::watchdog:
      return WatchdogResets::reason();
    case Fault::Kind::exception_return:
      return "return from an interrupt that never began, or whose return address was overwritten";
    default:
      return jump_text(fault);
  }
}

std::vector<SourceLine> Diagnosis::call_chain(std::uint32_t pc) const {
  std::vector<SourceLine> chain;
  const auto add = [&](std::uint32_t at) {
    std::vector<SourceLine> frames = debug_.frames(at);
    const Symbol* function =
        frames.empty() && firmware_.has_code(at) ? firmware_.symbols.function_at(at) : nullptr;
    if (function) frames.push_back({function->name, "", 0});
    for (const SourceLine& frame : frames)
      if (chain.size() < kMostCalls && (chain.empty() || !same_place(chain.back(), frame)))
        chain.push_back(frame);
  };
  add(pc);
  for (const std::uint32_t call : machine_.open_calls()) add(call);
  return chain;
}

std::string Diagnosis::registers() const {
  std::string text = fmt::format("PC 0x{:08X}  SP 0x{:08X}  LR 0x{:08X}  xPSR 0x{:08X}", cpu_.pc(),
                                 cpu_.reg(Cpu::kSp), cpu_.reg(Cpu::kLr), cpu_.status());
  for (int r = 0; r < 13; ++r) text += fmt::format("{}r{} {:08X}", r % 7 == 0 ? "\n" : "  ", r, cpu_.reg(r));
  return text;
}

Crash Diagnosis::crash(const Fault& fault) const {
  Crash crash;
  crash.reason = reason(fault);
  if (!is_jump(fault)) crash.where = debug_.place(fault.pc);
  // After a jump to an invalid address, reports the instruction that jumped there, or else an earlier jump.
  if (is_jump(fault))
    for (const std::uint32_t pc : cpu_.last_jumps())
      if (crash.where.file.empty()) crash.where = debug_.place(pc);
  if (crash.where.file.empty() && cpu_.in_handler()) crash.where = debug_.place(cpu_.interrupted_pc());
  if (crash.where.file.empty()) crash.where = place_of(machine_.open_calls());
  crash.calls = call_chain(is_jump(fault) ? cpu_.pc() : fault.pc);
  crash.registers = registers();
  return crash;
}

std::string Diagnosis::api_call(std::uint32_t pc) const {
  std::string name;
  const auto add = [&](std::uint32_t at) {
    for (const SourceLine& frame : debug_.frames(at)) {
      if (!is_core_file(frame.file)) return false;
      name = frame.function;
    }
    return true;
  };
  add(pc);
  return name.empty() || name == "main" || name == "load" || name == "store" ? "" : name + "()";
}

std::string Diagnosis::stopped_by() const {
  const Symbol* const stop = firmware_.symbols.find("robosim_stop_program");
  return stop && firmware_.symbols.function_at(cpu_.pc()) == stop ? "exit()" : "";
}

Activity Diagnosis::activity() const {
  Activity activity;
  activity.call = api_call(cpu_.last_io_pc());
  const Ports& ports = machine_.bus().ports();
  if (activity.call.starts_with("digitalRead") || activity.call.starts_with("pulseIn"))
    activity.pin = ports.last_read();
  const Clock& clock = machine_.bus().link().clock;
  if (clock.now - ports.last_read_at() <= clock.hz())
    activity.polled = machine_.bus().link().reads.only_pin();
  activity.where = where_now();
  activity.stopped_by = stopped_by();
  return activity;
}

}  // namespace robosim::exec::stm32
