#include "sim/detect/avr/reference_change.h"

#include <fmt/format.h>

#include "sim/detect/avr/call_site.h"
#include "sim/exec/avr/registers.h"

namespace robosim::detect::avr {
namespace {

constexpr int kManyChanges = 4, kManyUsed = 3;
constexpr SimTime kAgain = 50 * kMillisecond;  // a second reading within this time replaces the first

}  // namespace

ReferenceChange::ReferenceChange(const RunningProgram& program)
    : machine_(program.machine), debug_(program.debug), board_(program.board) {
  if (const auto begin = program.firmware.find("analogRead")) program.machine.chip().show(*this, *begin);
}

void ReferenceChange::visited(std::uint32_t, Cycle) {
  const robosim::avr::Cpu& cpu = machine_.chip().chip().cpu();
  const Read now{cpu.data[exec::avr::kArgument[0]], machine_.now(), call_site(cpu), std::nullopt};
  if (has_read_) {
    last_.reference = cpu.data[cpu.chip().at.adc_multiplexer] & robosim::avr::kRefs;
    if (before_.reference && before_.reference != last_.reference) {
      ++changes_;
      const bool again = now.pin == last_.pin && now.at - last_.at <= kAgain;
      if (!again && ++used_ >= kManyUsed && changes_ >= kManyChanges && !found_) found_ = last_;
    }
    before_ = last_;
  }
  last_ = now;
  has_read_ = true;
}

std::vector<Detected> ReferenceChange::found(SimTime) const {
  if (!found_) return {};
  const int number = found_->pin >= board_.analog_pin_0 ? found_->pin - board_.analog_pin_0 : found_->pin;
  return {{result::detector("reference_change"),
           fmt::format("the sketch used the first analogRead(A{}) after a change of the reference, before "
                       "the capacitor at AREF was charged",
                       number),
           "After analogReference(), read once, discard the result, and read again some milliseconds later.",
           debug_.place(found_->pc), 1e-9 * static_cast<double>(found_->at), used_}};
}

}  // namespace robosim::detect::avr
