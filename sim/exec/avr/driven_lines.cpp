#include "sim/exec/avr/driven_lines.h"

#include "hal/board/avr_registers.h"

namespace robosim::exec::avr {
namespace {

const SourceLine kUnknown;

}  // namespace

DrivenLines::DrivenLines(WatchedChip& chip, const Stack& stack, const DebugInfo& debug)
    : chip_(chip),
      stack_(stack),
      debug_(debug),
      pin_of_compare_(chip.spec().ram_address, -1),
      compared_by_(static_cast<std::size_t>(chip.spec().pin_count), nullptr) {
  const ChipSpec& spec = chip.spec();
  for (int pin = 0; pin < spec.pin_count; ++pin) {
    const ChipPin& place = spec.pins[pin];
    if (place.timer < 0) continue;
    if (const Address compare = spec.timers[place.timer].compare[place.output])
      pin_of_compare_[compare] = pin;
  }
  for (int timer = 0; timer < spec.timer_count; ++timer)
    for (std::size_t channel = 0; channel < std::size(spec.timers[timer].pins); ++channel)
      if (const char* const name = spec.timers[timer].pins[channel])
        pin_of_compare_[spec.timers[timer].compare[channel]] = chip.chip().pins().named(name);
  for (Address address = reg::kFirstIo; address < spec.ram_address; ++address)
    chip.chip().cpu().before_write<&DrivenLines::will_write>(address, this);
}

void DrivenLines::will_write(Address address) {
  written_at_ = chip_.cycle();
  if (const int pin = pin_of_compare_[address]; pin >= 0)
    compared_by_[static_cast<std::size_t>(pin)] = &line_now();
}

const SourceLine& DrivenLines::line_of(int pin, bool pwm) const {
  if (written_at_ == chip_.cycle()) return line_now();
  const SourceLine* const line = pwm ? compared_by_[static_cast<std::size_t>(pin)] : nullptr;
  return line ? *line : kUnknown;
}

const SourceLine& DrivenLines::line_now() const {
  const SourceLine* where = &debug_.place(chip_.last_pc());
  if (where->file.empty())
    stack_.each_call(chip_.in_handler() ? chip_.interrupted_pc() : 0, [&](const Stack::Call& call) {
      where = &debug_.place(call.pc);
      return !where->file.empty();
    });
  return *where;
}

}  // namespace robosim::exec::avr
