#include "sim/mcu/avr/infinite_loop.h"

#include "hal/board/avr_registers.h"
#include "sim/mcu/avr/instruction_effects.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::avr {
namespace {

bool is_of_processor(Address address) {
  return address == reg::kSreg || address == reg::kSpL || address == reg::kSpH;
}

// A reference state for cycle detection. The current state replaces the reference after 1, 2, 4 …
// instructions (Brent, 1980: An improved Monte Carlo factorization algorithm, section 2).
struct Reference {
  std::vector<std::uint8_t> data;
  std::uint32_t pc = 0;
  std::uint16_t sp = 0;
  std::uint8_t sreg = 0;

  explicit Reference(const Cpu& cpu) : data(cpu.data), pc(cpu.pc()), sp(cpu.sp()), sreg(cpu.sreg()) {}
  bool is(const Cpu& cpu) const {
    return cpu.pc() == pc && cpu.sp() == sp && cpu.sreg() == sreg && cpu.data == data;
  }
};

bool notes_reads(const InstructionEffects& effects, const Cpu& cpu, std::vector<bool>& reads) {
  for (unsigned i = 0; i < effects.bytes; ++i) {
    const auto address = static_cast<Address>(effects.address + i);
    if (address > cpu.last_ram()) return false;
    if (address < reg::kFirstIo || is_of_processor(address)) continue;
    if (address < cpu.chip().ram_address) return false;
    if (effects.memory == InstructionEffects::Memory::load) reads[address] = true;
  }
  return true;
}

// Visits each instruction of a handler once, and follows both directions of every branch.
class HandlerCode {
 public:
  explicit HandlerCode(const Cpu& cpu) : cpu_(cpu), seen_(cpu.flash().size() / 2), stores_(cpu.data.size()) {}

  bool follow(std::uint32_t pc) {
    for (open_.push_back(pc); !open_.empty();) {
      const std::uint32_t next = open_.back();
      open_.pop_back();
      if (next >= seen_.size()) return false;
      if (seen_[next]) continue;
      seen_[next] = true;
      if (!step(next)) return false;
    }
    return true;
  }
  Stores& stores() { return stores_; }

 private:
  bool step(std::uint32_t pc) {
    const Instruction& i = cpu_.instruction(pc);
    const auto behind = pc + i.words;
    const Control control = control_of(i.op);
    if (i.op == Op::reti) return true;
    if (control == Control::indirect_jump) return false;
    if (control == Control::jump || control == Control::branch) {
      open_.push_back(target_of(i, pc, static_cast<std::uint32_t>(seen_.size())));
      if (control == Control::jump) return true;
    } else if (const Location location = row_of(i.op).location;
               control == Control::skip && location == Location::none) {
      if (behind >= seen_.size()) return false;
      open_.push_back(behind + cpu_.instruction(behind).words);
    } else if (location != Location::stack) {
      const InstructionEffects e = effects_of(i, cpu_);
      if (e.elsewhere) return false;
      if (e.memory != InstructionEffects::Memory::none && !touches(i, e)) return false;
    }
    open_.push_back(behind);
    return true;
  }

  bool touches(const Instruction& i, const InstructionEffects& e) {
    const InstructionRow& row = row_of(i.op);
    const bool fixed = row.location == Location::address || row.location == Location::io;
    if (!fixed || row.control != Control::straight) return false;
    if (e.address == reg::kSreg) return true;
    if (e.address < cpu_.chip().ram_address || e.address >= stores_.size()) return false;
    if (e.memory == InstructionEffects::Memory::store) stores_[e.address] = true;
    return true;
  }

  const Cpu& cpu_;
  std::vector<bool> seen_;
  std::vector<std::uint32_t> open_;
  Stores stores_;
};

}  // namespace

std::optional<InfiniteLoop> find_infinite_loop(const Cpu& cpu, int most_instructions) {
  Cpu alone(cpu.chip(), cpu.flash(), cpu.last_ram());
  alone.data = cpu.data;
  alone.state = cpu.state;
  alone.state.sp_watch = 0;
  Reference reference(alone);
  InfiniteLoop round;
  round.reads.resize(alone.data.size());
  for (int i = 0, power = 1, since = 0; i < most_instructions; ++i) {
    const InstructionEffects effects = effects_of(alone.instruction(alone.pc()), alone);
    const bool leaves_handler = alone.instruction(alone.pc()).op == Op::reti;
    if ((effects.elsewhere && !leaves_handler) || !notes_reads(effects, alone, round.reads))
      return std::nullopt;
    round.interruptible |= alone.interrupts_enabled();
    if (alone.run(alone.cycle() + 1) != Cpu::Stop::reached) return std::nullopt;
    if (reference.is(alone)) return round;
    if (++since < power) continue;
    power *= 2;
    since = 0;
    reference = Reference(alone);
    round.reads.assign(round.reads.size(), false);
    round.interruptible = false;
  }
  return std::nullopt;
}

std::optional<Stores> stores_of_handler(const Cpu& cpu, int vector) {
  HandlerCode code(cpu);
  if (!code.follow(cpu.entry_of(vector))) return std::nullopt;
  return std::move(code.stores());
}

}  // namespace robosim::avr
