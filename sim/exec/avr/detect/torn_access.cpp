#include "sim/exec/avr/detect/torn_access.h"

#include <fmt/format.h>

#include "sim/exec/avr/demangle.h"

namespace robosim::exec::avr {
namespace {

constexpr const char* kInterruptsOff = "with interrupts off (noInterrupts(), ATOMIC_BLOCK)";

}  // namespace

const char* check_of(RaceAnalysis::AccessKind kind) {
  switch (kind) {
    case RaceAnalysis::AccessKind::reads:
      return "torn_read";
    case RaceAnalysis::AccessKind::writes:
      return "torn_write";
    case RaceAnalysis::AccessKind::writes_back:
      return "lost_update";
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

TornAccess::TornAccess(Machine& machine, const Program& program)
    : machine_(machine),
      debug_(program.debug),
      race_analysis_(program.firmware, program.debug, machine.chip().chip(),
                     [this](std::uint32_t pc) { machine_.chip().show(*this, pc); }) {
  machine.chip().show_handlers(*this);
}

void TornAccess::visited(std::uint32_t pc, robosim::avr::Cycle) { race_analysis_.visited(pc); }

void TornAccess::entered(int vector, robosim::avr::Cycle) { race_analysis_.entered(vector); }

void TornAccess::left() {
  if (race_analysis_.found()) return;
  race_analysis_.left();
  if (race_analysis_.found()) found_at_ = machine_.now();
}

std::vector<Detected> TornAccess::found() const {
  const auto& found = race_analysis_.found();
  if (!found) return {};
  std::string mend = fix_of(found->kind) + ".";
  mend[0] = static_cast<char>(mend[0] - 'a' + 'A');
  return {{check_of(found->kind), torn_text(*found, debug_, machine_.chip().clock_hz()), mend,
           debug_.place(found->pc), 1e-9 * static_cast<double>(found_at_), 1}};
}

}  // namespace robosim::exec::avr
