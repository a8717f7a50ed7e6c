#include "sim/mcu/avr/counter_extrapolation.h"

#include <algorithm>

#include "hal/board/avr_registers.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kC = Cpu::kC, kZ = Cpu::kZ, kN = Cpu::kN;
constexpr std::uint8_t kSigned = Cpu::kV | Cpu::kS;
constexpr std::uint8_t kArithmetic = kC | kZ | kN | kSigned | Cpu::kH;

constexpr std::uint8_t kPointers = 26;  // X, Y, Z
// Limits of a tracked sum or difference: its value, its step, and the index of its last byte. If a result
// exceeds a limit, its operands are held instead of tracked. No typical sketch exceeds a limit.
constexpr std::int64_t kMost = std::int64_t{1} << 48, kSteepest = std::int64_t{1} << 24;
constexpr int kBytes = 5;

constexpr std::int64_t size_of(int bits) { return std::int64_t{1} << bits; }
constexpr std::int64_t low_bits(std::int64_t value, int bits) { return value & (size_of(bits) - 1); }
constexpr bool is_within(std::int64_t value, std::int64_t most) { return -most < value && value < most; }

bool is_difference(Op op) {
  return op == Op::sub || op == Op::sbc || op == Op::subi || op == Op::sbci || op == Op::cp ||
         op == Op::cpc || op == Op::cpi;
}
bool carries(Op op) { return op == Op::adc || op == Op::sbc || op == Op::sbci || op == Op::cpc; }
bool has_constant(Op op) { return op == Op::subi || op == Op::sbci || op == Op::cpi; }
bool only_compares(Op op) { return op == Op::cp || op == Op::cpc || op == Op::cpi; }

}  // namespace

void CounterExtrapolation::begin() {
  has_counter_ = false;
  registers_.fill({});
  memory_.clear();
  chain_.reset();
  window_ = std::numeric_limits<std::int64_t>::max();
}

void CounterExtrapolation::counter_read(unsigned reg) {
  has_counter_ = true;
  registers_[reg] = Byte{{cpu_.data[reg], 1}, 0};
}

bool CounterExtrapolation::agrees(std::uint32_t registers) const {
  bool all = true;
  each(registers, [&](unsigned reg) {
    if (const Operand& byte = registers_[reg])
      all &= static_cast<std::uint8_t>(byte->line.now >> (8 * byte->k)) == cpu_.data[reg];
  });
  return all;
}

// --- holding

/// Limits the window to the counts for which `line` changes only in its lowest `bits` bits.
void CounterExtrapolation::keep(const Line& line, int bits) {
  if (line.step == 0) return;
  const std::int64_t within = low_bits(line.now, bits);
  const std::int64_t room = line.step > 0 ? (size_of(bits) - 1 - within) / line.step : within / -line.step;
  window_ = std::min(window_, room);
}

void CounterExtrapolation::hold(Operand& operand) {
  if (operand) keep(operand->line, 8 * operand->k);
  operand.reset();
}

void CounterExtrapolation::hold_registers(std::uint32_t registers) {
  each(registers, [this](unsigned reg) { hold(registers_[reg]); });
}

CounterExtrapolation::Operand* CounterExtrapolation::find(Address address) {
  if (address < registers_.size()) return &registers_[address];
  for (auto& [where, operand] : memory_)
    if (where == address) return &operand;
  return nullptr;
}

void CounterExtrapolation::hold(Address address) {
  if (Operand* const there = find(address)) hold(*there);
}

void CounterExtrapolation::hold_flags(unsigned flags) {
  if (!chain_) return;
  const auto [subtracts, whole, left, right, result, k] = *chain_;
  const int sign = 8 * k + 7, end = 8 * k + 8;
  if (flags & kC)
    for (const Line& line : {left, right, result}) keep(line, end);
  if (flags & kN) keep(result, sign);
  if (flags & kSigned)
    for (const Line& line : {left, right, result}) keep(line, sign);
  if (flags & kZ) hold_zero();
  if (flags & Cpu::kH)
    for (const Line& line : {left, right, result}) keep(line, 8 * k);
}

void CounterExtrapolation::hold_zero() {
  const auto [subtracts, whole, left, right, result, k] = *chain_;
  const bool zero = low_bits(result.now >> (8 * k), 8) == 0;
  if (whole) {
    if (low_bits(result.now, 8 * k + 8) == 0) {
      window_ = std::min<std::int64_t>(window_, result.step == 0 ? window_ : 0);
    } else {
      keep(result, 8 * k + 8);
      keep({result.now - 1, result.step}, 8 * k + 8);
    }
  } else if (zero && subtracts) {
    window_ = 0;
  } else {
    keep(result, 8 * k);
  }
}

void CounterExtrapolation::hold_all_flags() {
  hold_flags(kArithmetic);
  chain_.reset();
}

// --- following

void CounterExtrapolation::follow(const Instruction& instruction, const InstructionEffects& effects) {
  if (!has_counter_) return;
  switch (instruction.op) {
    case Op::mov:
      registers_[instruction.a] = registers_[instruction.b];
      return;
    case Op::movw:
      registers_[instruction.a] = registers_[instruction.b];
      registers_[instruction.a + 1u] = registers_[instruction.b + 1u];
      return;
    case Op::add:
    case Op::adc:
    case Op::sub:
    case Op::sbc:
    case Op::subi:
    case Op::sbci:
    case Op::cp:
    case Op::cpc:
    case Op::cpi:
      return add_or_subtract(instruction);
    case Op::adiw:
    case Op::sbiw:
      return add_word(instruction);
    default:
      break;
  }
  if (effects.memory == InstructionEffects::Memory::load) return load(instruction, effects);
  if (effects.memory == InstructionEffects::Memory::store) return store(instruction, effects);
  compute(effects);
}

/// Holds all inputs of an instruction, so that its result is the same for all n in the window.
void CounterExtrapolation::compute(const InstructionEffects& effects) {
  hold_registers(effects.reads);
  hold_flags(effects.flags_read);
  if (effects.flags_written & kArithmetic) hold_all_flags();
  each(effects.writes, [this](unsigned reg) { registers_[reg].reset(); });
}

void CounterExtrapolation::load(const Instruction& instruction, const InstructionEffects& effects) {
  if (effects.address == reg::kSreg) hold_flags(kArithmetic);
  const bool is_one_byte = instruction.op != Op::ret && effects.writes != 0;
  Operand loaded;
  for (unsigned i = 0; i < effects.bytes; ++i) {
    Operand* const there = find(static_cast<Address>(effects.address + i));
    if (there && is_one_byte) {
      loaded = *there;
    } else if (there) {
      hold(*there);
    }
  }
  compute(effects);
  if (is_one_byte) registers_[instruction.a] = loaded;
}

void CounterExtrapolation::store(const Instruction& instruction, const InstructionEffects& effects) {
  const bool is_io = effects.address >= reg::kFirstIo && effects.address < cpu_.chip().ram_address;
  const bool has_pointer = instruction.op != Op::push && instruction.op != Op::sts;
  const bool is_pointers = has_pointer && instruction.a >= kPointers;
  Operand stored;
  if (!is_call(instruction.op) && !is_io && !is_pointers) stored = registers_[instruction.a];
  InstructionEffects others = effects;
  if (stored) others.reads &= ~(std::uint32_t{1} << instruction.a);
  compute(others);
  if (effects.address == reg::kSreg) chain_.reset();
  for (unsigned i = 0; i < effects.bytes; ++i) {
    const auto address = static_cast<Address>(effects.address + i);
    Operand* const there = find(address);
    if (there) {
      *there = stored;
    } else if (stored) {
      memory_.emplace_back(address, stored);
    }
  }
}

/// Returns the Line of a number with the lower k bytes of `line` and a new byte k. Byte k is `byte`, or
/// `constant` if `byte` is empty. Returns nothing if `byte` belongs to a number with other lower bytes.
std::optional<CounterExtrapolation::Line> CounterExtrapolation::extended(const Line& line,
                                                                         const Operand& byte,
                                                                         std::uint8_t constant, int k) {
  if (!byte) {
    keep(line, 8 * k);
    return Line{low_bits(line.now, 8 * k) + (std::int64_t{constant} << (8 * k)), line.step};
  }
  const std::int64_t apart = (byte->line.now - line.now) | (byte->line.step - line.step);
  if (byte->k != k || low_bits(apart, 8 * k) != 0) return std::nullopt;
  return byte->line;
}

std::optional<CounterExtrapolation::Chain> CounterExtrapolation::chained(const Instruction& instruction,
                                                                         const Operand& right,
                                                                         std::uint8_t constant) {
  Chain chain = *chain_;
  ++chain.k;
  if (chain.subtracts != is_difference(instruction.op)) return std::nullopt;
  const auto left_line = extended(chain.left, registers_[instruction.a], cpu_.data[instruction.a], chain.k);
  const auto right_line = extended(chain.right, right, constant, chain.k);
  if (!left_line || !right_line) return std::nullopt;
  chain.left = *left_line;
  chain.right = *right_line;
  if (!chain.subtracts) chain.whole = false;
  return chain;
}

std::optional<CounterExtrapolation::Chain> CounterExtrapolation::begun(const Instruction& instruction,
                                                                       const Operand& right,
                                                                       std::uint8_t constant) {
  const Operand& left = registers_[instruction.a];
  const bool carry = carries(instruction.op) && cpu_.sreg() & kC;
  Chain chain;
  chain.subtracts = is_difference(instruction.op);
  chain.k = left ? left->k : right->k;
  if (left && right && (left->k != right->k || chain.k != 0 || carry)) return std::nullopt;
  // Subtracting the Line of `right` would also subtract its bytes below k, which may borrow from byte k. The
  // instruction subtracts only byte k.
  if (right && chain.subtracts && chain.k != 0) return std::nullopt;
  const auto line = [&](std::uint8_t value) { return Line{std::int64_t{value} << (8 * chain.k), 0}; };
  chain.left = left ? left->line : line(cpu_.data[instruction.a]);
  chain.right = right ? right->line : line(constant);
  if (carry) {
    // Adds the carry to the constant, which must still fit in a byte.
    if (right || constant == 0xFF) return std::nullopt;
    chain.right.now += size_of(8 * chain.k);
  }
  chain.whole = chain.k == 0 && !carries(instruction.op);
  return chain;
}

void CounterExtrapolation::add_or_subtract(const Instruction& instruction) {
  const Op op = instruction.op;
  const bool is_chained = carries(op) && chain_;
  Operand right;
  if (!has_constant(op)) right = registers_[instruction.b];
  const std::uint8_t constant = has_constant(op) ? instruction.b : cpu_.data[instruction.b & 31u];
  Operand& left = registers_[instruction.a];
  if (!left && !right && !is_chained) {
    chain_.reset();
    return;
  }
  auto chain = is_chained ? chained(instruction, right, constant) : begun(instruction, right, constant);
  if (chain) {
    const Line &l = chain->left, &r = chain->right;
    const int sign = chain->subtracts ? -1 : 1;
    chain->result = {l.now + sign * r.now, l.step + sign * r.step};
    const bool is_short =
        chain->k <= kBytes && is_within(chain->result.now, kMost) && is_within(chain->result.step, kSteepest);
    if (!is_short) chain.reset();
  }
  if (!chain) {
    hold(left);
    if (!has_constant(op)) hold(registers_[instruction.b]);
    if (carries(op)) hold_flags(kC | kZ);
    chain_.reset();
    return;
  }
  chain_ = chain;
  if (!only_compares(op)) left = Byte{chain->result, chain->k};
}

void CounterExtrapolation::add_word(const Instruction& instruction) {
  Operand &low = registers_[instruction.a], &high = registers_[instruction.a + 1u];
  hold_all_flags();
  if (!low && !high) return;
  std::optional<Line> left;
  if (!low || low->k == 0)
    left =
        extended(low ? low->line : Line{cpu_.data[instruction.a], 0}, high, cpu_.data[instruction.a + 1u], 1);
  if (!left) {
    hold(low);
    return hold(high);
  }
  Chain chain;
  chain.subtracts = instruction.op == Op::sbiw;
  chain.whole = true;
  chain.k = 1;
  chain.left = *left;
  chain.right = {instruction.b, 0};
  chain.result = {left->now + (chain.subtracts ? -1 : 1) * instruction.b, left->step};
  low = Byte{chain.result, 0};
  high = Byte{chain.result, 1};
  chain_ = chain;
}

}  // namespace robosim::avr
