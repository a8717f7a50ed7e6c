#include "sim/mcu/avr/self_programming.h"

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kSpmen = 0x01, kSigrd = 0x20, kOperation = 0x3F;
constexpr Cycle kLpmWindow = 3, kSpmWindow = 4;

}  // namespace

SelfProgramming::SelfProgramming(Core& core) : core_(core) {
  core.cpu.on_write<&SelfProgramming::write>(reg::kSpmcsr, this);
  window_ends_ = core.events.add<&SelfProgramming::window_ends>(this);
}

void SelfProgramming::reset(Cycle) { core_.cpu.state.reads_signature = false; }

void SelfProgramming::write(Address address, std::uint8_t value) {
  core_.at(address) = value;
  const bool asks = (value & kOperation) == (kSigrd | kSpmen);
  core_.cpu.state.reads_signature = asks;
  core_.schedule(window_ends_, core_.now() + (asks ? kLpmWindow : kSpmWindow));
}

void SelfProgramming::window_ends(Cycle at) {
  if (core_.cpu.state.reads_signature) {
    core_.cpu.state.reads_signature = false;
    return core_.schedule(window_ends_, at + kSpmWindow - kLpmWindow);
  }
  core_.at(reg::kSpmcsr) &= static_cast<std::uint8_t>(~kOperation);
}

}  // namespace robosim::avr
