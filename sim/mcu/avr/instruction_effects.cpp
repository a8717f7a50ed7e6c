#include "sim/mcu/avr/instruction_effects.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kCarry = Cpu::kC, kZero = Cpu::kZ, kTransfer = Cpu::kT;
constexpr std::uint8_t kSignFlags = Cpu::kZ | Cpu::kN | Cpu::kV | Cpu::kS, kShiftFlags = kSignFlags | kCarry,
                       kAllFlags = kShiftFlags | Cpu::kH;
constexpr Address kPairX = 26, kPairY = 28, kPairZ = 30;

constexpr std::uint32_t one(unsigned reg) { return std::uint32_t{1} << reg; }
constexpr std::uint32_t two(unsigned reg) { return std::uint32_t{3} << reg; }

class Writer {
 public:
  explicit Writer(const Cpu& cpu) : cpu_(cpu) {}

  void computes(std::uint32_t reads, std::uint32_t writes, std::uint8_t flags_written,
                std::uint8_t flags_read = 0) {
    e.reads |= reads;
    e.writes |= writes;
    e.flags_written = flags_written;
    e.flags_read = flags_read;
  }
  void loads(unsigned reg, Address address) {
    at(InstructionEffects::Memory::load, address, 1, 2);
    e.writes |= one(reg);
  }
  void stores(unsigned reg, Address address) {
    at(InstructionEffects::Memory::store, address, 1, 2);
    e.reads |= one(reg);
  }
  void at(InstructionEffects::Memory memory, Address address, unsigned bytes, unsigned touched) {
    e.memory = memory;
    e.address = address;
    e.bytes = static_cast<std::uint8_t>(bytes);
    e.touched = static_cast<std::uint8_t>(touched);
  }
  /// Records an access through a pointer, which moves by `step` before (-1) or after (1) the access. Returns
  /// the accessed address.
  Address by(Address pointer, int step, int offset = 0) {
    e.reads |= two(pointer);
    if (step != 0) e.writes |= two(pointer);
    return static_cast<Address>(cpu_.pair(pointer) + offset + (step < 0 ? -1 : 0));
  }
  void calls() {
    const unsigned bytes = cpu_.chip().return_address_bytes;
    at(InstructionEffects::Memory::store, static_cast<Address>(cpu_.sp() - bytes + 1), bytes, 2);
  }

  InstructionEffects e;

 private:
  const Cpu& cpu_;
};

}  // namespace

InstructionEffects effects_of(const Instruction& i, const Cpu& cpu) {
  Writer w(cpu);
  const std::uint32_t a = one(i.a & 31u), b = one(i.b & 31u);
  switch (i.op) {
    case Op::nop:
      break;
    case Op::add:
    case Op::sub:
      w.computes(a | b, a, kAllFlags);
      break;
    case Op::adc:
      w.computes(a | b, a, kAllFlags, kCarry);
      break;
    case Op::sbc:
      w.computes(a | b, a, kAllFlags, kCarry | kZero);
      break;
    case Op::and_:
    case Op::or_:
      w.computes(a | b, a, kSignFlags);
      break;
    case Op::eor:
      w.computes(i.a == i.b ? 0 : a | b, a, kSignFlags);
      break;
    case Op::mov:
      w.computes(b, a, 0);
      break;
    case Op::movw:
      w.computes(two(i.b), two(i.a), 0);
      break;
    case Op::cp:
      w.computes(a | b, 0, kAllFlags);
      break;
    case Op::cpc:
      w.computes(a | b, 0, kAllFlags, kCarry | kZero);
      break;
    case Op::cpse:
      w.computes(a | b, 0, 0);
      break;
    case Op::mul:
    case Op::muls:
    case Op::mulsu:
    case Op::fmul:
    case Op::fmuls:
    case Op::fmulsu:
      w.computes(a | b, two(0), kCarry | kZero);
      break;
    case Op::subi:
      w.computes(a, a, kAllFlags);
      break;
    case Op::sbci:
      w.computes(a, a, kAllFlags, kCarry | kZero);
      break;
    case Op::andi:
    case Op::ori:
      w.computes(a, a, kSignFlags);
      break;
    case Op::ldi:
      w.computes(0, a, 0);
      break;
    case Op::cpi:
      w.computes(a, 0, kAllFlags);
      break;
    case Op::adiw:
    case Op::sbiw:
      w.computes(two(i.a), two(i.a), kShiftFlags);
      break;
    case Op::com:
    case Op::asr:
    case Op::lsr:
      w.computes(a, a, kShiftFlags);
      break;
    case Op::ror:
      w.computes(a, a, kShiftFlags, kCarry);
      break;
    case Op::neg:
      w.computes(a, a, kAllFlags);
      break;
    case Op::swap:
      w.computes(a, a, 0);
      break;
    case Op::inc:
    case Op::dec:
      w.computes(a, a, kSignFlags);
      break;
    case Op::bld:
      w.computes(a, a, 0, kTransfer);
      break;
    case Op::bst:
      w.computes(a, 0, kTransfer);
      break;
    case Op::push:
      w.stores(i.a, cpu.sp());
      break;
    case Op::pop:
      w.loads(i.a, static_cast<Address>(cpu.sp() + 1));
      break;
    case Op::ld_x:
      w.loads(i.a, w.by(kPairX, 0));
      break;
    case Op::ld_x_inc:
      w.loads(i.a, w.by(kPairX, 1));
      break;
    case Op::ld_x_dec:
      w.loads(i.a, w.by(kPairX, -1));
      break;
    case Op::ldd_y:
      w.loads(i.a, w.by(kPairY, 0, i.b));
      break;
    case Op::ld_y_inc:
      w.loads(i.a, w.by(kPairY, 1));
      break;
    case Op::ld_y_dec:
      w.loads(i.a, w.by(kPairY, -1));
      break;
    case Op::ldd_z:
      w.loads(i.a, w.by(kPairZ, 0, i.b));
      break;
    case Op::ld_z_inc:
      w.loads(i.a, w.by(kPairZ, 1));
      break;
    case Op::ld_z_dec:
      w.loads(i.a, w.by(kPairZ, -1));
      break;
    case Op::lds:
      w.loads(i.a, static_cast<Address>(i.k));
      break;
    case Op::st_x:
      w.stores(i.a, w.by(kPairX, 0));
      break;
    case Op::st_x_inc:
      w.stores(i.a, w.by(kPairX, 1));
      break;
    case Op::st_x_dec:
      w.stores(i.a, w.by(kPairX, -1));
      break;
    case Op::std_y:
      w.stores(i.a, w.by(kPairY, 0, i.b));
      break;
    case Op::st_y_inc:
      w.stores(i.a, w.by(kPairY, 1));
      break;
    case Op::st_y_dec:
      w.stores(i.a, w.by(kPairY, -1));
      break;
    case Op::std_z:
      w.stores(i.a, w.by(kPairZ, 0, i.b));
      break;
    case Op::st_z_inc:
      w.stores(i.a, w.by(kPairZ, 1));
      break;
    case Op::st_z_dec:
      w.stores(i.a, w.by(kPairZ, -1));
      break;
    case Op::sts:
      w.stores(i.a, static_cast<Address>(i.k));
      break;
    case Op::lpm_0:
      w.computes(two(kPairZ), one(0), 0);
      break;
    case Op::lpm:
      w.computes(two(kPairZ), a, 0);
      break;
    case Op::lpm_inc:
      w.computes(two(kPairZ), two(kPairZ) | a, 0);
      break;
    case Op::in:
      w.loads(i.a, static_cast<Address>(i.k));
      w.e.touched = 1;
      break;
    case Op::out:
      w.stores(i.a, static_cast<Address>(i.k));
      w.e.touched = 1;
      break;
    case Op::sbic:
    case Op::sbis:
      w.at(InstructionEffects::Memory::load, static_cast<Address>(i.k), 1, 1);
      break;
    case Op::rjmp:
    case Op::jmp:
      break;
    case Op::brbs:
    case Op::brbc:
      w.computes(0, 0, 0, i.b);
      break;
    case Op::sbrc:
    case Op::sbrs:
      w.computes(a, 0, 0);
      break;
    case Op::ijmp:
      w.computes(two(kPairZ), 0, 0);
      break;
    case Op::rcall:
    case Op::call:
      w.calls();
      break;
    case Op::icall:
      w.computes(two(kPairZ), 0, 0);
      w.calls();
      break;
    case Op::ret:
      w.at(InstructionEffects::Memory::load, static_cast<Address>(cpu.sp() + 1),
           cpu.chip().return_address_bytes, 2);
      break;
    case Op::bset:
    case Op::bclr:
      w.computes(0, 0, i.b);
      break;
    default:
      w.e.elsewhere = true;
      break;
  }
  return w.e;
}

}  // namespace robosim::avr
