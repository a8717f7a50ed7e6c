#include "sim/exec/avr/lost_pwm.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/exec/avr/call_site.h"

namespace robosim::exec::avr {
namespace {

constexpr unsigned kPin = 24, kValue = 22;  // registers
constexpr int kOn = 255;

std::string pins_with_pwm(const BoardSpec& board) {
  std::string names;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].pwm) names += fmt::format("{}{}", names.empty() ? "" : ", ", pin);
  return names;
}

}  // namespace

LostPwm::LostPwm(Machine& machine, const Program& program)
    : machine_(machine), debug_(program.debug), board_(program.board) {
  if (const auto begin = program.firmware.find("analogWrite")) machine.chip().show(*this, *begin);
}

void LostPwm::visited(std::uint32_t, robosim::avr::Cycle) {
  const robosim::avr::Cpu& cpu = machine_.chip().chip().cpu();
  const Pin pin = cpu.data[kPin];
  const auto value = static_cast<std::int16_t>(cpu.data[kValue] | cpu.data[kValue + 1] << 8);
  if (pin >= board_.pin_count || board_.pins[pin].pwm || !board_.pins[pin].digital) return;
  if (value <= 0 || value >= kOn) return;
  const auto known =
      std::find_if(calls_.begin(), calls_.end(), [&](const Call& call) { return call.pin == pin; });
  if (known != calls_.end()) {
    ++known->times;
    return;
  }
  calls_.push_back({pin, value, machine_.now(), call_site(cpu), 1});
}

std::vector<Detected> LostPwm::found() const {
  std::vector<Detected> all;
  for (const Call& call : calls_)
    all.push_back(
        {"lost_pwm",
         fmt::format("pin {} of the {} has no PWM, and is LOW below 128, else HIGH: analogWrite({}, {})",
                     call.pin, board_.name, call.pin, call.value),
         fmt::format("Wire it to a pin that has: {}.", pins_with_pwm(board_)), debug_.place(call.pc),
         1e-9 * static_cast<double>(call.at), call.times});
  return all;
}

}  // namespace robosim::exec::avr
