#include "sim/mcu/avr/cpu.h"

#include <algorithm>
#include <bit>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kErased = 0xFF;
constexpr std::uint16_t kErasedWord = 0xFFFF;
// Up to this flash size, an interrupt vector has one word. In a larger flash it has two words, for a JMP.
constexpr std::uint32_t kFlashOfRelativeJumps = 0x2000;
bool counts_down(const Instruction& first, const Instruction& second) {
  return first.op == Op::sbiw && first.b == 1 && second.op == Op::brbc && second.b == Cpu::kZ &&
         second.k == -2;
}

/// Returns the equivalent operation that is specialised for the instruction's operands.
Op quick(const Instruction& i) {
  if (i.op != Op::brbs && i.op != Op::brbc) return i.op;
  const bool set = i.op == Op::brbs;
  switch (i.b) {
    case Cpu::kC:
      return set ? Op::brcs : Op::brcc;
    case Cpu::kZ:
      return set ? Op::breq : Op::brne;
    case Cpu::kN:
      return set ? Op::brmi : Op::brpl;
    case Cpu::kS:
      return set ? Op::brlt : Op::brge;
    default:
      return i.op;
  }
}

constexpr unsigned key_of(Op first, Op second) {
  return static_cast<unsigned>(first) << 8 | static_cast<unsigned>(second);
}

/// Returns the operation that runs both instructions; `first` if no such operation exists.
Op both_of(Op first, Op second) {
  switch (key_of(first, second)) {
#define ROBOSIM_AVR_CASE(x, one, other) \
  case key_of(Op::one, Op::other):      \
    return Op::one##_##other;
    ROBOSIM_AVR_PAIRS(ROBOSIM_AVR_CASE, )
#undef ROBOSIM_AVR_CASE
    default:
      return first;
  }
}

/// Returns whether an AVRe core lacks the operation: multiplication, JMP, CALL, or an extended operation
/// (ELPM, EIJMP, EICALL).
bool needs_large_core(Op op) {
  switch (op) {
    case Op::mul:
    case Op::muls:
    case Op::mulsu:
    case Op::fmul:
    case Op::fmuls:
    case Op::fmulsu:
    case Op::jmp:
    case Op::call:
    case Op::elpm_0:
    case Op::elpm:
    case Op::elpm_inc:
    case Op::eijmp:
    case Op::eicall:
      return true;
    default:
      return false;
  }
}

}  // namespace

Cpu::Cpu(const ChipSpec& chip, std::span<const std::uint8_t> flash, Address last_ram)
    : data(last_ram + 1u),
      chip_(chip),
      flash_(flash.begin(), flash.end()),
      ram_begin_(static_cast<Address>(chip.ram_address)),
      last_ram_(last_ram),
      hooks_(chip.ram_address),
      plain_(chip.ram_address, kPlainRead | kPlainWrite) {
  for (const Address elsewhere : {reg::kSreg, reg::kSpL, reg::kSpH}) plain_[elsewhere] = 0;
  flash_.resize(std::bit_ceil(std::max<std::size_t>(flash_.size(), 2)), kErased);
  // Does not decode the erased end of the flash, which is usually the largest part: all erased words decode
  // to the same instruction.
  const std::size_t words = flash_.size() / 2;
  words_ = static_cast<std::uint32_t>(words);
  std::size_t used = words;
  while (used > 0 && flash_[2 * used - 1] == kErased && flash_[2 * used - 2] == kErased) --used;
  used = std::min(used + 1, words);  // the second word of an instruction may look erased
  original_ = decode(std::span<const std::uint8_t>(flash_).first(2 * used));
  original_.resize(words, decode(kErasedWord, kErasedWord));
  if (chip.small_core)
    for (Instruction& instruction : original_)
      if (needs_large_core(instruction.op)) instruction = {};
  original_.insert(original_.end(), 2, {Op::outside});
  code_ = original_;
  marks_.resize(code_.size());
  unmarked_.resize(code_.size(), original_[words - 1].op);
  find_time_count(used);
  for (std::uint32_t pc = 0; pc < used; ++pc) prepare(pc);
  for (const std::size_t pc : {words - 1, words, words + 1}) prepare(static_cast<std::uint32_t>(pc));
  state.sp = state.sp_watch = last_ram;
}

void Cpu::find_time_count(std::size_t words) {
  for (std::size_t pc = 0; pc + TimeCount::kWords <= words && !time_count_; ++pc) {
    if (original_[pc].op != Op::push) continue;
    time_count_ = time_count_of(std::span<const std::uint8_t>(flash_).subspan(2 * pc),
                                std::span<const Instruction>(original_).subspan(pc), ram_begin_, last_ram_);
    time_count_pc_ = static_cast<std::uint32_t>(pc);
  }
}

void Cpu::reset() {
  std::fill(data.begin() + reg::kFirstIo, data.begin() + ram_begin_, std::uint8_t{0});
  state.pc = 0;
  state.sp = last_ram_;
  state.sreg = 0;
  state.held_at = kNoCycle;
  if (state.open_handlers > 0) state.handler_cycles += state.cycle - state.handler_began;
  state.open_handlers = 0;
  state.passing = ~0u;
}

void Cpu::set_sreg(std::uint8_t value) {
  if (value & ~state.sreg & kI) {
    state.held_at = state.cycle;
    if (!waiting || *waiting) look_up();
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
  if (address < reg::kFirstIo) return data[address];
  if (address > last_ram_) {
    state.bad_address = address;
    stop_with(Stop::bad_read);
    return 0;
  }
  switch (address) {
    case reg::kSreg:
      return state.sreg;
    case reg::kSpL:
      return static_cast<std::uint8_t>(state.sp);
    case reg::kSpH:
      return static_cast<std::uint8_t>(state.sp >> 8);
    default:
      break;
  }
  touch();
  if (state.cycle >= horizon_) on_time();
  const Hook& hook = hooks_[address];
  return hook.read ? hook.read(hook.read_self, address) : data[address];
}

void Cpu::store_elsewhere(Address address, std::uint8_t value) {
  if (address < reg::kFirstIo) {
    data[address] = value;
    return;
  }
  if (address > last_ram_) {
    state.bad_address = address;
    return stop_with(Stop::bad_write);
  }
  switch (address) {
    case reg::kSreg:
      if (!is_in_prologue(state.last_pc)) touch();
      return set_sreg(value);
    case reg::kSpL:
      state.sp_before = state.sp;
      state.sp = static_cast<std::uint16_t>((state.sp & 0xFF00) | value);
      return on_sp_written();
    case reg::kSpH:
      state.sp_before = state.sp;
      state.sp = static_cast<std::uint16_t>((state.sp & 0xFF) | value << 8);
      return on_sp_written();
    default:
      break;
  }
  touch();
  if (state.cycle >= horizon_) on_time();
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
  const std::uint16_t sp = state.sp;
  if (chip_.return_address_bytes == 2 && sp > ram_begin_ && sp <= last_ram_ && sp - 2 >= state.sp_watch)
      [[likely]] {
    data[sp] = static_cast<std::uint8_t>(pc);
    data[sp - 1u] = static_cast<std::uint8_t>(pc >> 8);
    state.sp = static_cast<std::uint16_t>(sp - 2);
    return;
  }
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
  state.vector = static_cast<std::uint8_t>(vector);
  if (state.open_handlers++ == 0) state.handler_began = state.cycle;
  state.last_pc = state.pc;
  state.sreg &= static_cast<std::uint8_t>(~kI);
  state.pc = entry_of(vector);
  state.cycle += chip_.return_address_bytes == 3 ? 5 : 4;
  on_entered();
  push_pc(state.last_pc);
}

void Cpu::count_time(Cycle until) {
  constexpr Cycle kJump = 3, kReturn = 4;
  const Instruction& jump = code_[state.pc];
  if (!time_count_ || jump.op != Op::jmp || static_cast<std::uint32_t>(jump.k) != time_count_pc_ ||
      code_[time_count_pc_].op != Op::count_time)
    return;
  const int sp = state.sp, deepest = sp - TimeCount::kPushes;
  if (state.cycle + kJump + TimeCount::kCycles + 1 >= until || chip_.return_address_bytes != 2 || !waiting ||
      *waiting || sp + 2 > last_ram_ || deepest < time_count_->last || deepest < state.sp_watch)
    return;
  state.cycle += kJump + static_cast<Cycle>(time_count_->count(data.data(), state.sp, state.sreg)) + kReturn;
  state.last_pc = time_count_pc_ + TimeCount::kWords - 1;
  note_jump(state.last_pc);
  state.pc = target_of(static_cast<std::uint32_t>(data[state.sp + 1u] << 8 | data[state.sp + 2u]));
  state.sp = static_cast<std::uint16_t>(sp + 2);
  leave_handler();
  state.held_at = state.cycle;
  state.sreg |= kI;
}

std::uint32_t Cpu::entry_of(int vector) const {
  return static_cast<std::uint32_t>(vector) * (chip_.flash_bytes > kFlashOfRelativeJumps ? 2 : 1);
}

void Cpu::set_open_handlers(int count) {
  if (state.open_handlers > 0) state.handler_cycles += state.cycle - state.handler_began;
  state.open_handlers = count;
  state.handler_began = state.cycle;
}

std::uint8_t Cpu::signature_row(std::uint32_t address) const {
  return address < 2 * std::size(chip_.signature) && address % 2 == 0 ? chip_.signature[address / 2]
                                                                      : kErased;
}

void Cpu::write_bit(Address address, std::uint8_t bit, bool set) {
  const auto changed = [&](std::uint8_t before) {
    return static_cast<std::uint8_t>(set ? before | bit : before & ~bit);
  };
  const Hook& hook = hooks_[address];
  if (!hook.write_bit) return store(address, changed(load(address)));
  touch();
  if (state.cycle >= horizon_) on_time();
  hook.write_bit(hook.write_bit_self, address, changed(data[address]), bit);
}

void Cpu::skip_if(bool taken) {
  if (!taken) return;
  const std::uint8_t words = code_[state.pc].words;
  state.pc += words;
  state.cycle += words;
}

Op Cpu::alone(std::uint32_t pc) const {
  const Instruction& i = original_[pc];
  if (is_count(pc)) return Op::count_down;
  if (i.op == Op::in && i.k == reg::kSreg) return Op::in_sreg;
  if (i.op == Op::out && i.k == reg::kSreg) return is_in_prologue(pc) ? Op::prologue_out_sreg : Op::out_sreg;
  if (i.op != Op::lds && i.op != Op::sts) return quick(i);
  if (i.k < ram_begin_ || i.k > last_ram_) return i.op;
  return i.op == Op::lds ? Op::lds_ram : Op::sts_ram;
}

bool Cpu::reads_number(std::uint32_t pc) const {
  if (pc + kWordsOfNumberRead > original_.size() || alone(pc) != Op::in_sreg) return false;
  const Instruction &disables = original_[pc + 1], &last = original_[pc + kWordsOfNumberRead - 1];
  const std::uint8_t kept = original_[pc].a;
  if (disables.op != Op::bclr || disables.b != kI || last.op != Op::out || last.k != reg::kSreg ||
      last.a != kept)
    return false;
  for (std::uint32_t i = 0; i < 4; ++i)
    if (alone(pc + 2 + 2 * i) != Op::lds_ram || original_[pc + 2 + 2 * i].a == kept) return false;
  return true;
}

// Returns the operation for `pc`, ignoring a mark at `pc`. A marked instruction is never the second of a
// pair, because run() stops before it.
Op Cpu::unmarked(std::uint32_t pc) const {
  const Op first = alone(pc);
  const auto none_marked = [&](std::uint32_t words) {
    const auto begin = marks_.begin() + pc + 1;
    return std::none_of(begin, begin + words - 1, [](std::uint8_t mark) { return mark != 0; });
  };
  if (is_in_time_count(pc) && pc == time_count_pc_ && none_marked(TimeCount::kWords)) return Op::count_time;
  if (reads_number(pc) && none_marked(kWordsOfNumberRead)) return Op::read_number;
  const std::size_t behind = pc + original_[pc].words;
  if (behind >= original_.size() || marks_[behind]) return first;
  return both_of(first, alone(static_cast<std::uint32_t>(behind)));
}

void Cpu::prepare(std::uint32_t pc) {
  unmarked_[pc] = unmarked(pc);
  code_[pc].op = marks_[pc] ? Op::mark : unmarked_[pc];
}

bool Cpu::is_count(std::uint32_t pc) const { return pc > 0 && counts_down(original_[pc - 1], original_[pc]); }

void Cpu::put_mark(std::uint32_t pc, std::uint8_t kind, bool set) {
  marks_[pc] = static_cast<std::uint8_t>(set ? marks_[pc] | kind : marks_[pc] & ~kind);
  if (!marks_[pc] && state.passing == pc) state.passing = ~0u;
  for (std::uint32_t before = std::min(pc, kWordsOfNumberRead - 1); before > 0; --before)
    prepare(pc - before);
  prepare(pc);
  if (is_in_time_count(pc)) prepare(time_count_pc_);
}

void Cpu::set_mark(std::uint32_t pc, bool set) { put_mark(pc, kMark, set); }
void Cpu::set_head(std::uint32_t pc, bool set) { put_mark(pc, kHead, set); }

ReadForecast Cpu::forecast(Address address, std::uint8_t bits) const {
  const Hook& hook = hooks_[address];
  if (hook.forecast) return hook.forecast(hook.forecast_self, address, bits);
  if (!hook.read) return {kNoCycle, data[address]};
  if (hook.is_steady) return {kNoCycle, hook.read(hook.read_self, address)};
  return {};
}

std::uint8_t Cpu::bits_read(std::uint32_t pc) const {
  const Instruction& reads = instruction(pc);
  if (reads.op == Op::sbic || reads.op == Op::sbis) return reads.b;
  if (reads.op != Op::in && reads.op != Op::ld_x && reads.op != Op::ldd_y && reads.op != Op::ldd_z &&
      reads.op != Op::lds)
    return kAllBits;
  const Instruction& next = instruction(pc + reads.words);
  if (next.op == Op::andi && next.a == reads.a) return next.b;
  if (next.op != Op::and_) return kAllBits;
  if (next.a == reads.a) return next.b == reads.a ? kAllBits : data[next.b];
  // Recognises the Arduino core's digitalRead(): AND stores its result in the register of the mask, and LDI
  // then overwrites the value that was read.
  const Instruction& after = instruction(pc + reads.words + next.words);
  const bool replaced = after.op == Op::ldi && after.a == reads.a;
  return next.b == reads.a && replaced ? data[next.a] : kAllBits;
}

std::uint8_t Cpu::bits_tested(std::uint32_t pc) const {
  const std::uint8_t bits = bits_read(pc);
  if (bits != kAllBits) return bits;
  const Instruction& reads = instruction(pc);
  std::uint32_t at = pc + reads.words;
  unsigned value = reads.a;
  if (const Instruction& copy = instruction(at); copy.op == Op::mov && copy.b == value) {
    value = copy.a;
    at += copy.words;
  }
  const Instruction& test = instruction(at);
  const bool skips = test.op == Op::sbrc || test.op == Op::sbrs;
  if ((skips || test.op == Op::andi) && test.a == value) return test.b;
  if (test.op != Op::and_ || test.a == test.b) return kAllBits;
  return test.a == value ? data[test.b] : test.b == value ? data[test.a] : kAllBits;
}

std::vector<std::uint32_t> Cpu::last_jumps() const {
  std::vector<std::uint32_t> jumps;
  for (std::uint32_t i = state.jump_count; i-- > 0 && jumps.size() < state.jumps.size();)
    jumps.push_back(state.jumps[i % state.jumps.size()]);
  return jumps;
}

}  // namespace robosim::avr
