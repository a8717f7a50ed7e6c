#include "sim/exec/avr/detect/lost_pwm.h"

#include "sim/exec/avr/detect/call_site.h"

namespace robosim::exec::avr {

LostPwm::LostPwm(Machine& machine, const Program& program)
    : machine_(machine), debug_(program.debug), calls_(program.board) {
  if (const auto begin = program.firmware.find("analogWrite")) machine.chip().show(*this, *begin);
}

void LostPwm::visited(std::uint32_t, robosim::avr::Cycle) {
  const robosim::avr::Cpu& cpu = machine_.chip().chip().cpu();
  const auto value = static_cast<std::int16_t>(cpu.data[kArgument[1]] | cpu.data[kArgument[1] + 1] << 8);
  calls_.add(cpu.data[kArgument[0]], value, machine_.now(), [&] { return debug_.place(call_site(cpu)); });
}

}  // namespace robosim::exec::avr
