#include "sim/detect/avr/analog_write_calls.h"

#include "sim/detect/avr/call_site.h"
#include "sim/exec/avr/registers.h"

namespace robosim::detect::avr {

using exec::avr::kArgument;

AnalogWriteCalls::AnalogWriteCalls(const RunningProgram& program) : program_(program), calls_(program.board) {
  if (const auto begin = program.firmware.find("analogWrite")) program.machine.chip().show(*this, *begin);
}

void AnalogWriteCalls::visited(std::uint32_t, Cycle) {
  const robosim::avr::Cpu& cpu = program_.machine.chip().chip().cpu();
  const auto value = static_cast<std::int16_t>(cpu.data[kArgument[1]] | cpu.data[kArgument[1] + 1] << 8);
  calls_.add(cpu.data[kArgument[0]], value, program_.machine.now(),
             [&] { return program_.debug.place(call_site(cpu)); });
}

}  // namespace robosim::detect::avr
