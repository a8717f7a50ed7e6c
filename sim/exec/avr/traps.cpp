#include <algorithm>
#include <utility>

#include "sim/exec/avr/chip.h"

namespace robosim::exec::avr {

void Chip::invalid_opcode() {
  const std::uint32_t pc = avr_->pc;
  if (const auto place = trap_place(pc); place != traps_.end()) {
    trapped_ = place->traps;
    avr_->state = cpu_Stopped;
    avr_->cycle -= 1;  // libsimavr is about to add one for the trap
    return;
  }
  if (word(pc) != kTrapOpcode) return fail(Fault::Kind::bad_opcode, pc, word(pc));
  fail(pc == 0 ? Fault::Kind::restart : Fault::Kind::bad_jump, pc, 0);
}

std::vector<Chip::TrapPlace>::iterator Chip::trap_place(std::uint32_t pc) {
  return std::find_if(traps_.begin(), traps_.end(), [&](const TrapPlace& place) { return place.pc == pc; });
}

void Chip::set_trap(Trap trap, std::uint32_t pc) {
  auto place = trap_place(pc);
  if (place == traps_.end()) place = traps_.insert(place, {pc, word(pc), 0});
  place->traps |= trap;
  set_word(pc, kTrapOpcode);
}

void Chip::clear_trap(Trap trap, std::uint32_t pc) {
  const auto place = trap_place(pc);
  if (place == traps_.end()) return;
  place->traps &= ~static_cast<unsigned>(trap);
  if (place->traps != 0) return;
  set_word(pc, place->opcode);
  traps_.erase(place);
}

unsigned Chip::take_traps() { return std::exchange(trapped_, 0); }

void Chip::pass_trap() {
  const auto place = trap_place(*passing_);
  passing_.reset();
  avr_->run_cycle_count = 0;
  if (place == traps_.end()) {
    avr_run(avr_);
    return;
  }
  set_word(place->pc, place->opcode);
  avr_run(avr_);
  set_word(place->pc, kTrapOpcode);
}

}  // namespace robosim::exec::avr
