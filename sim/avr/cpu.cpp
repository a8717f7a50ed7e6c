#include "sim/avr/cpu.h"

#include <algorithm>
#include <bit>

namespace robosim::avr {
namespace {

constexpr Address kXLow = 26, kYLow = 28, kZLow = 30;
constexpr Address kSpl = 0x5D, kSph = 0x5E, kSreg = 0x5F, kRampz = 0x5B, kEind = 0x5C;
constexpr Address kFirstIo = 0x20;
constexpr std::uint8_t kErased = 0xFF;
// Above this the vectors are two words apart, room for a JMP.
constexpr std::uint32_t kFlashOfRelativeJumps = 0x2000;

}  // namespace

Cpu::Cpu(const ChipSpec& chip, std::span<const std::uint8_t> flash, Address last_ram)
    : data(last_ram + 1u),
      chip_(chip),
      flash_(flash.begin(), flash.end()),
      ram_begin_(static_cast<Address>(chip.ram_address)),
      last_ram_(last_ram),
      hooks_(chip.ram_address) {
  flash_.resize(std::bit_ceil(flash_.size()), kErased);
  original_ = decode(flash_);
  original_.insert(original_.end(), 2, {Op::outside});
  code_ = original_;
  state.sp = state.sp_watch = last_ram;
}

void Cpu::reset() {
  std::fill(data.begin() + kFirstIo, data.begin() + ram_begin_, std::uint8_t{0});
  state.pc = 0;
  state.sp = last_ram_;
  state.sreg = 0;
  state.held = false;
  if (state.open_handlers > 0) state.handler_cycles += state.cycle - state.handler_began;
  state.open_handlers = 0;
  state.passing = ~0u;
}

void Cpu::set_sreg(std::uint8_t value) {
  if (value & ~state.sreg & kI) {
    state.held = true;
    look_up();
  }
  state.sreg = value;
}

void Cpu::touch() {
  if (state.open_handlers > 0) return;
  state.last_io = state.cycle;
  state.last_io_pc = state.last_pc;
}

std::uint8_t Cpu::load(Address address) {
  return address >= ram_begin_ && address <= last_ram_ ? data[address] : load_elsewhere(address);
}

void Cpu::store(Address address, std::uint8_t value) {
  if (address >= ram_begin_ && address <= last_ram_) {
    data[address] = value;
  } else {
    store_elsewhere(address, value);
  }
}

std::uint8_t Cpu::load_elsewhere(Address address) {
  if (address < kFirstIo) return data[address];
  if (address > last_ram_) {
    state.bad_address = address;
    stop_with(Stop::bad_read);
    return 0;
  }
  switch (address) {
    case kSreg: return state.sreg;
    case kSpl: return static_cast<std::uint8_t>(state.sp);
    case kSph: return static_cast<std::uint8_t>(state.sp >> 8);
    default: break;
  }
  touch();
  on_time();
  const Hook& hook = hooks_[address];
  return hook.read ? hook.read(hook.read_self, address) : data[address];
}

void Cpu::store_elsewhere(Address address, std::uint8_t value) {
  if (address < kFirstIo) {
    data[address] = value;
    return;
  }
  if (address > last_ram_) {
    state.bad_address = address;
    return stop_with(Stop::bad_write);
  }
  switch (address) {
    case kSreg: return set_sreg(value);
    case kSpl:
      state.sp = static_cast<std::uint16_t>((state.sp & 0xFF00) | value);
      return on_sp_written();
    case kSph:
      state.sp = static_cast<std::uint16_t>((state.sp & 0xFF) | value << 8);
      return on_sp_written();
    default: break;
  }
  touch();
  on_time();
  const Hook& hook = hooks_[address];
  if (hook.write) {
    hook.write(hook.write_self, address, value);
  } else {
    data[address] = value;
  }
}

void Cpu::push(std::uint8_t value) {
  store(state.sp--, value);
  if (state.sp < state.sp_watch) on_sp_low();
}

std::uint8_t Cpu::pop() { return load(++state.sp); }

void Cpu::push_pc(std::uint32_t pc) {
  for (int i = 0; i < chip_.return_address_bytes; ++i, pc >>= 8) push(static_cast<std::uint8_t>(pc));
}

std::uint32_t Cpu::pop_pc() {
  std::uint32_t pc = 0;
  for (int i = 0; i < chip_.return_address_bytes; ++i) pc = pc << 8 | pop();
  return pc;
}

void Cpu::enter(int vector) {
  note_jump(state.pc);
  state.interrupted_pc = state.pc;
  if (state.open_handlers++ == 0) state.handler_began = state.cycle;
  state.last_pc = state.pc;
  push_pc(state.pc);
  state.sreg &= static_cast<std::uint8_t>(~kI);
  state.pc = static_cast<std::uint32_t>(vector) * (chip_.flash_bytes > kFlashOfRelativeJumps ? 2 : 1);
  state.cycle += chip_.return_address_bytes == 3 ? 5 : 4;
}

void Cpu::leave_handler() {
  if (state.open_handlers == 0 || --state.open_handlers > 0) return;
  state.handler_cycles += state.cycle - state.handler_began;
}

void Cpu::set_mark(std::uint32_t pc, bool set) {
  code_[pc].op = set ? Op::mark : original_[pc].op;
}

std::vector<std::uint32_t> Cpu::last_jumps() const {
  std::vector<std::uint32_t> jumps;
  for (std::uint32_t i = state.jump_count; i-- > 0 && jumps.size() < state.jumps.size();)
    jumps.push_back(state.jumps[i % state.jumps.size()]);
  return jumps;
}

Cpu::Stop Cpu::run(Cycle until) {
  stop_ = Stop::horizon;
  horizon_ = until;
  state.held = false;

  // What every instruction needs is kept in registers: stores to `r` could be stores to any member.
  Cycle cycle = state.cycle;
  std::uint32_t pc = state.pc, began = pc;
  std::uint8_t sreg = state.sreg;
  std::uint16_t sp = state.sp;
  std::uint8_t* const r = data.data();
  const Instruction* const code = code_.data();
  const auto words = static_cast<std::uint32_t>(code_.size() - 2);
  const std::uint32_t wrap = std::bit_ceil(words) - 1;
  const Address ram_begin = ram_begin_, ram_span = static_cast<Address>(last_ram_ - ram_begin_);
  const unsigned pc_bytes = chip_.return_address_bytes;

#define INLINE __attribute__((always_inline))
  const auto put = [&]() INLINE {
    state.cycle = cycle;
    state.pc = pc;
    state.last_pc = began;
    state.sreg = sreg;
    state.sp = sp;
  };
  const auto take = [&]() INLINE {
    cycle = state.cycle;
    pc = state.pc;
    sreg = state.sreg;
    sp = state.sp;
  };
  const auto load = [&](Address address) INLINE {
    if (static_cast<Address>(address - ram_begin) <= ram_span) [[likely]] return r[address];
    put();
    const std::uint8_t value = load_elsewhere(address);
    take();
    return value;
  };
  const auto store = [&](Address address, std::uint8_t value) INLINE {
    if (static_cast<Address>(address - ram_begin) <= ram_span) [[likely]] {
      r[address] = value;
      return;
    }
    put();
    store_elsewhere(address, value);
    take();
  };
  const auto push = [&](std::uint8_t value) INLINE {
    store(sp--, value);
    if (sp < state.sp_watch) [[unlikely]] {
      put();
      on_sp_low();
    }
  };
  const auto push_pc = [&] {
    note_jump(began);
    push(static_cast<std::uint8_t>(pc));
    push(static_cast<std::uint8_t>(pc >> 8));
    if (pc_bytes == 3) push(static_cast<std::uint8_t>(pc >> 16));
  };
  const auto jump = [&](std::uint32_t to) INLINE {
    pc = to;
    if (to >= words) [[unlikely]] pc = words;
  };
  const auto pop_pc = [&] {
    note_jump(began);
    std::uint32_t to = 0;
    for (unsigned i = 0; i < pc_bytes; ++i) to = to << 8 | load(++sp);
    jump(to);
  };
  const auto pair = [&](Address low) INLINE { return static_cast<std::uint16_t>(r[low] | r[low + 1] << 8); };
  const auto set_pair = [&](Address low, unsigned value) INLINE {
    r[low] = static_cast<std::uint8_t>(value);
    r[low + 1] = static_cast<std::uint8_t>(value >> 8);
  };
  // S, N and Z of a result whose V is `v`.
  const auto signs = [](std::uint8_t result, bool v) INLINE {
    const bool n = result & 0x80;
    return static_cast<unsigned>((result == 0 ? kZ : 0) | (n ? kN : 0) | (v ? kV : 0) | (n != v ? kS : 0));
  };
  const auto sum = [&](std::uint8_t d, std::uint8_t s, unsigned carry) INLINE {
    const unsigned wide = d + s + carry;
    const auto result = static_cast<std::uint8_t>(wide);
    const bool v = ((d ^ result) & (s ^ result)) & 0x80;
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT)) | signs(result, v) | (wide >> 8) |
                                     ((d ^ s ^ result) << 1 & kH));
    return result;
  };
  const auto difference = [&](std::uint8_t d, std::uint8_t s, unsigned carry, bool keep_zero) INLINE {
    const unsigned wide = d - s - carry;
    const auto result = static_cast<std::uint8_t>(wide);
    const bool v = ((d ^ s) & (d ^ result)) & 0x80;
    unsigned zero = ~0u;
    if (keep_zero) zero = sreg | ~static_cast<unsigned>(kZ);
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT)) | (signs(result, v) & zero) | (wide >> 8 & kC) |
                                     ((d ^ s ^ result) << 1 & kH));
    return result;
  };
  const auto logic = [&](unsigned value) INLINE {
    const auto result = static_cast<std::uint8_t>(value);
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT | kH | kC)) | signs(result, false));
    return result;
  };
  const auto counted = [&](unsigned value, bool v) INLINE {
    const auto result = static_cast<std::uint8_t>(value);
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT | kH | kC)) | signs(result, v));
    return result;
  };
  const auto shifted = [&](unsigned value, bool c) INLINE {
    const auto result = static_cast<std::uint8_t>(value);
    const bool n = result & 0x80;
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT | kH)) | signs(result, n != c) | (c ? kC : 0));
    return result;
  };
  const auto added_word = [&](unsigned after, bool v) INLINE {
    const bool n = after & 0x8000, c = after & 0x10000;
    sreg = static_cast<std::uint8_t>((sreg & (kI | kT | kH)) | ((after & 0xFFFF) == 0 ? kZ : 0) |
                                     (n ? kN : 0) | (v ? kV : 0) | (n != v ? kS : 0) | (c ? kC : 0));
  };
  const auto product = [&](int value, int shift) INLINE {
    const auto result = static_cast<std::uint16_t>(value << shift);
    sreg = static_cast<std::uint8_t>((sreg & ~(kC | kZ)) | (value & 0x8000 ? kC : 0) | (result == 0 ? kZ : 0));
    set_pair(0, result);
    cycle += 1;
  };
  const auto s8 = [&](Address at) INLINE { return static_cast<std::int8_t>(r[at]); };
  const auto program = [&](std::uint32_t address) INLINE {
    cycle += 2;
    return address < flash_.size() ? flash_[address] : std::uint8_t{0xFF};
  };
  const auto far_z = [&] { return pair(kZLow) | static_cast<std::uint32_t>(data[kRampz]) << 16; };
  const auto far_jump = [&] { return pair(kZLow) | static_cast<std::uint32_t>(data[kEind]) << 16; };
  const auto branch = [&](bool taken, std::int32_t k) INLINE {
    if (!taken) return;
    pc = (pc + static_cast<std::uint32_t>(k)) & wrap;
    cycle += 1;
  };
  const auto skip = [&](bool taken) INLINE {
    if (!taken) return;
    const unsigned count = code[pc].words;
    pc += count;
    cycle += count;
  };
  // Loads and stores through a pointer: `step` before (negative) or after (positive) the access.
  const auto load_by = [&](std::uint8_t to, Address pointer, int step) INLINE {
    Address at = pair(pointer);
    if (step < 0) at = static_cast<Address>(at - 1);
    if (step != 0) set_pair(pointer, step < 0 ? at : at + 1u);
    cycle += 1;
    r[to] = load(at);
  };
  const auto store_by = [&](std::uint8_t from, Address pointer, int step) INLINE {
    const std::uint8_t value = r[from];
    Address at = pair(pointer);
    if (step < 0) at = static_cast<Address>(at - 1);
    if (step != 0) set_pair(pointer, step < 0 ? at : at + 1u);
    cycle += 1;
    store(at, value);
  };
  const auto end = [&](Stop why) INLINE {
    put();
    stop_with(why);
  };
#undef INLINE

  while (cycle < horizon_) {
    const Instruction* i = code + pc;
    began = pc;
    pc += i->words;
    cycle += 1;
  again:
    switch (i->op) {
      case Op::nop: break;
      case Op::add: r[i->a] = sum(r[i->a], r[i->b], 0); break;
      case Op::adc: r[i->a] = sum(r[i->a], r[i->b], sreg & kC); break;
      case Op::sub: r[i->a] = difference(r[i->a], r[i->b], 0, false); break;
      case Op::sbc: r[i->a] = difference(r[i->a], r[i->b], sreg & kC, true); break;
      case Op::and_: r[i->a] = logic(r[i->a] & r[i->b]); break;
      case Op::or_: r[i->a] = logic(r[i->a] | r[i->b]); break;
      case Op::eor: r[i->a] = logic(r[i->a] ^ r[i->b]); break;
      case Op::mov: r[i->a] = r[i->b]; break;
      case Op::movw: set_pair(i->a, pair(i->b)); break;
      case Op::cp: difference(r[i->a], r[i->b], 0, false); break;
      case Op::cpc: difference(r[i->a], r[i->b], sreg & kC, true); break;
      case Op::cpse: skip(r[i->a] == r[i->b]); break;
      case Op::mul: product(r[i->a] * r[i->b], 0); break;
      case Op::muls: product(s8(i->a) * s8(i->b), 0); break;
      case Op::mulsu: product(s8(i->a) * r[i->b], 0); break;
      case Op::fmul: product(r[i->a] * r[i->b], 1); break;
      case Op::fmuls: product(s8(i->a) * s8(i->b), 1); break;
      case Op::fmulsu: product(s8(i->a) * r[i->b], 1); break;

      case Op::subi: r[i->a] = difference(r[i->a], i->b, 0, false); break;
      case Op::sbci: r[i->a] = difference(r[i->a], i->b, sreg & kC, true); break;
      case Op::andi: r[i->a] = logic(r[i->a] & i->b); break;
      case Op::ori: r[i->a] = logic(r[i->a] | i->b); break;
      case Op::ldi: r[i->a] = i->b; break;
      case Op::cpi: difference(r[i->a], i->b, 0, false); break;
      case Op::adiw: {
        const unsigned before = pair(i->a), after = before + i->b;
        set_pair(i->a, after);
        added_word(after, ~before & after & 0x8000);
        cycle += 1;
        break;
      }
      case Op::sbiw: {
        const unsigned before = pair(i->a), after = before - i->b;
        set_pair(i->a, after);
        added_word(after, before & ~after & 0x8000);
        cycle += 1;
        break;
      }

      case Op::com:
        r[i->a] = logic(~r[i->a] & 0xFFu);
        sreg |= kC;
        break;
      case Op::neg: r[i->a] = difference(0, r[i->a], 0, false); break;
      case Op::swap: r[i->a] = static_cast<std::uint8_t>(r[i->a] << 4 | r[i->a] >> 4); break;
      case Op::inc: r[i->a] = counted(r[i->a] + 1u, r[i->a] == 0x7F); break;
      case Op::dec: r[i->a] = counted(r[i->a] - 1u, r[i->a] == 0x80); break;
      case Op::asr: r[i->a] = shifted(static_cast<unsigned>(s8(i->a) >> 1), r[i->a] & 1); break;
      case Op::lsr: r[i->a] = shifted(r[i->a] >> 1, r[i->a] & 1); break;
      case Op::ror: r[i->a] = shifted(static_cast<unsigned>(r[i->a] >> 1 | (sreg & kC) << 7), r[i->a] & 1); break;
      case Op::bld:
        r[i->a] = static_cast<std::uint8_t>(sreg & kT ? r[i->a] | i->b : r[i->a] & ~i->b);
        break;
      case Op::bst: sreg = static_cast<std::uint8_t>(r[i->a] & i->b ? sreg | kT : sreg & ~kT); break;
      case Op::push:
        cycle += 1;
        push(r[i->a]);
        break;
      case Op::pop: {
        cycle += 1;
        r[i->a] = load(++sp);
        break;
      }

      case Op::ld_x: load_by(i->a, kXLow, 0); break;
      case Op::ld_x_inc: load_by(i->a, kXLow, 1); break;
      case Op::ld_x_dec: load_by(i->a, kXLow, -1); break;
      case Op::ld_y_inc: load_by(i->a, kYLow, 1); break;
      case Op::ld_y_dec: load_by(i->a, kYLow, -1); break;
      case Op::ld_z_inc: load_by(i->a, kZLow, 1); break;
      case Op::ld_z_dec: load_by(i->a, kZLow, -1); break;
      case Op::ldd_y:
        cycle += 1;
        r[i->a] = load(static_cast<Address>(pair(kYLow) + i->b));
        break;
      case Op::ldd_z:
        cycle += 1;
        r[i->a] = load(static_cast<Address>(pair(kZLow) + i->b));
        break;
      case Op::lds:
        cycle += 1;
        r[i->a] = load(static_cast<Address>(i->k));
        break;
      case Op::st_x: store_by(i->a, kXLow, 0); break;
      case Op::st_x_inc: store_by(i->a, kXLow, 1); break;
      case Op::st_x_dec: store_by(i->a, kXLow, -1); break;
      case Op::st_y_inc: store_by(i->a, kYLow, 1); break;
      case Op::st_y_dec: store_by(i->a, kYLow, -1); break;
      case Op::st_z_inc: store_by(i->a, kZLow, 1); break;
      case Op::st_z_dec: store_by(i->a, kZLow, -1); break;
      case Op::std_y:
        cycle += 1;
        store(static_cast<Address>(pair(kYLow) + i->b), r[i->a]);
        break;
      case Op::std_z:
        cycle += 1;
        store(static_cast<Address>(pair(kZLow) + i->b), r[i->a]);
        break;
      case Op::sts:
        cycle += 1;
        store(static_cast<Address>(i->k), r[i->a]);
        break;

      case Op::lpm_0: r[0] = program(pair(kZLow)); break;
      case Op::lpm: r[i->a] = program(pair(kZLow)); break;
      case Op::lpm_inc: {
        const Address at = pair(kZLow);
        set_pair(kZLow, at + 1u);
        r[i->a] = program(at);
        break;
      }
      case Op::elpm_0: r[0] = program(far_z()); break;
      case Op::elpm: r[i->a] = program(far_z()); break;
      case Op::elpm_inc: {
        const std::uint32_t at = far_z();
        set_pair(kZLow, at + 1);
        r[kRampz] = static_cast<std::uint8_t>((at + 1) >> 16);
        r[i->a] = program(at);
        break;
      }

      case Op::in: r[i->a] = load(static_cast<Address>(i->k)); break;
      case Op::out: store(static_cast<Address>(i->k), r[i->a]); break;
      case Op::sbi:
      case Op::cbi: {
        const auto address = static_cast<Address>(i->k);
        const bool set = i->op == Op::sbi;
        const auto changed = [&](std::uint8_t before) {
          return static_cast<std::uint8_t>(set ? before | i->b : before & ~i->b);
        };
        cycle += 1;
        const Hook& hook = hooks_[address];
        if (!hook.write_bit) {
          store(address, changed(load(address)));
          break;
        }
        put();
        touch();
        on_time();
        hook.write_bit(hook.write_bit_self, address, changed(data[address]), i->b);
        take();
        break;
      }
      case Op::sbic: skip(!(load(static_cast<Address>(i->k)) & i->b)); break;
      case Op::sbis: skip(load(static_cast<Address>(i->k)) & i->b); break;

      case Op::rjmp: branch(true, i->k); break;
      case Op::jmp:
        cycle += 2;
        jump(static_cast<std::uint32_t>(i->k));
        break;
      case Op::ijmp:
        cycle += 1;
        jump(pair(kZLow));
        break;
      case Op::eijmp:
        cycle += 1;
        jump(far_jump());
        break;
      case Op::rcall:
        cycle += pc_bytes;
        push_pc();
        pc = (pc + static_cast<std::uint32_t>(i->k)) & wrap;
        break;
      case Op::call:
        cycle += 1 + pc_bytes;
        push_pc();
        jump(static_cast<std::uint32_t>(i->k));
        break;
      case Op::icall:
        cycle += pc_bytes;
        push_pc();
        jump(pair(kZLow));
        break;
      case Op::eicall:
        cycle += 3;
        push_pc();
        jump(far_jump());
        break;
      case Op::ret:
        cycle += 1 + pc_bytes;
        pop_pc();
        break;
      case Op::reti:
        cycle += 1 + pc_bytes;
        pop_pc();
        put();
        leave_handler();
        set_sreg(static_cast<std::uint8_t>(sreg | kI));
        sreg = state.sreg;
        break;
      case Op::brbs: branch(sreg & i->b, i->k); break;
      case Op::brbc: branch(!(sreg & i->b), i->k); break;
      case Op::sbrc: skip(!(r[i->a] & i->b)); break;
      case Op::sbrs: skip(r[i->a] & i->b); break;

      case Op::bset:
        if (i->b == kI) {
          state.sreg = sreg;
          set_sreg(static_cast<std::uint8_t>(sreg | kI));
        }
        sreg |= i->b;
        break;
      case Op::bclr: sreg &= static_cast<std::uint8_t>(~i->b); break;
      case Op::wdr:
        put();
        on_time();
        on_wdr();
        break;
      case Op::sleep: end(Stop::sleep); break;
      case Op::break_: end(Stop::break_); break;
      case Op::spm: end(Stop::spm); break;
      case Op::mark:
        if (state.passing == began) {
          state.passing = ~0u;
          i = original_.data() + began;
          goto again;
        }
        state.passing = began;
        pc = began;
        cycle -= 1;
        end(Stop::mark);
        break;
      case Op::illegal:
        pc = began;
        cycle -= 1;
        end(Stop::illegal);
        break;
      case Op::outside:
        pc = began;
        cycle -= 1;
        end(Stop::outside);
        break;
    }
  }
  put();
  return stop_;
}

}  // namespace robosim::avr
