#include "sim/exec/avr/detect/torn_number.h"

#include <fmt/format.h>

#include "sim/exec/avr/readable.h"

namespace robosim::exec::avr {
namespace {

constexpr const char* kInterruptsOff = "with interrupts off (noInterrupts(), ATOMIC_BLOCK)";

}  // namespace

const char* check_of(Tearing::Deed deed) {
  switch (deed) {
    case Tearing::Deed::reads:
      return "torn_read";
    case Tearing::Deed::writes:
      return "torn_write";
    case Tearing::Deed::writes_back:
      return "lost_update";
  }
  return "";
}

std::string mend_of(Tearing::Deed deed) {
  const char* const what = deed == Tearing::Deed::reads    ? "copy"
                           : deed == Tearing::Deed::writes ? "write"
                                                           : "change";
  return fmt::format("{} it {}", what, kInterruptsOff);
}

std::string torn_text(const Tearing::Found& found, const DebugInfo& debug, std::uint32_t clock_hz) {
  const double later_us = 1e6 * static_cast<double>(found.later) / clock_hz;
  const SourceLine at = debug.place(found.handler_pc);
  const std::string handler =
      at.file.empty() ? "a handler" : fmt::format("the handler at {}:{}", at.file, at.line);
  if (found.deed == Tearing::Deed::writes_back)
    return fmt::format(
        "lost update of {}, which is read, changed and written back: {} changes it in an interrupt, and ran "
        "only {:.1f} µs too late for its change to be lost",
        readable(found.number->name), handler, later_us);
  const bool writes = found.deed == Tearing::Deed::writes;
  return fmt::format(
      "torn {} of {}, whose {} bytes the chip {} one by one: {} changes them in an interrupt, and ran only "
      "{:.0f} µs too late to mix bytes of the old and the new number",
      writes ? "write" : "read", readable(found.number->name), found.number->size,
      writes ? "writes" : "reads", handler, later_us);
}

TornNumber::TornNumber(Machine& machine, const Program& program)
    : machine_(machine),
      debug_(program.debug),
      tearing_(program.firmware, program.debug, machine.chip().chip(),
               [this](std::uint32_t pc) { machine_.chip().show(*this, pc); }) {
  machine.chip().show_handlers(*this);
}

void TornNumber::visited(std::uint32_t pc, robosim::avr::Cycle) { tearing_.visited(pc); }

void TornNumber::entered(int vector, robosim::avr::Cycle) { tearing_.entered(vector); }

void TornNumber::left() {
  if (tearing_.found()) return;
  tearing_.left();
  if (tearing_.found()) found_at_ = machine_.now();
}

std::vector<Detected> TornNumber::found() const {
  const auto& found = tearing_.found();
  if (!found) return {};
  std::string mend = mend_of(found->deed) + ".";
  mend[0] = static_cast<char>(mend[0] - 'a' + 'A');
  return {{check_of(found->deed), torn_text(*found, debug_, machine_.chip().clock_hz()), mend,
           debug_.place(found->pc), 1e-9 * static_cast<double>(found_at_), 1}};
}

}  // namespace robosim::exec::avr
