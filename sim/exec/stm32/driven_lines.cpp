#include "sim/exec/stm32/driven_lines.h"

#include "hal/stm32/addresses.h"

namespace robosim::exec::stm32 {
namespace {

const SourceLine kUnknown;

Address compare_of(const robosim::ChipPin& pin) {
  return robosim::stm32::timer_address(pin.timer) + robosim::stm32::kTimCcr1 + 4u * pin.output;
}

}  // namespace

DrivenLines::DrivenLines(Machine& machine, const DebugInfo& debug) : machine_(machine), debug_(debug) {
  const BoardSpec& spec = machine.bus().link().board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    if (const robosim::ChipPin& place = spec.pins[pin].chip_pin; place.timer >= 0)
      compared_by_[compare_of(place)];
  machine.before_stores([this](Address address) { will_store(address); });
}

void DrivenLines::will_store(Address address) {
  const auto compare = compared_by_.find(address & ~3u);
  if (compare != compared_by_.end()) compare->second = &line_now();
}

const SourceLine& DrivenLines::line_of(const PinSpec& pin, bool pwm) const {
  if (machine_.bus().is_storing()) return line_now();
  if (!pwm || pin.chip_pin.timer < 0) return kUnknown;
  const SourceLine* const line = compared_by_.at(compare_of(pin.chip_pin));
  return line ? *line : kUnknown;
}

const SourceLine& DrivenLines::line_now() const {
  const Cpu& cpu = machine_.cpu();
  const auto first_of = [&](const std::vector<std::uint32_t>& places) -> const SourceLine& {
    for (const std::uint32_t pc : places)
      if (const SourceLine& where = debug_.place(pc); !where.file.empty()) return where;
    return kUnknown;
  };
  if (const SourceLine& here = debug_.place(cpu.pc()); !here.file.empty()) return here;
  // Examines jumps first, because a tail call leaves no return address on the stack. In a handler, ignores
  // the stack, because its calls may belong to the interrupted code.
  const SourceLine& jumped = first_of(cpu.last_jumps());
  return jumped.file.empty() && !cpu.in_handler() ? first_of(machine_.open_calls()) : jumped;
}

}  // namespace robosim::exec::stm32
