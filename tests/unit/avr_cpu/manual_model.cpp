#include "tests/unit/avr_cpu/manual_model.h"

#include <cstring>

namespace robosim::avr {
namespace {

constexpr std::uint16_t kX = 26, kY = 28, kZ = 30;

bool bit(unsigned value, unsigned number) { return value >> number & 1; }

/// The opcode bits for which a pattern has a digit. `mask` selects these bits, and `value` has their values.
struct Fixed {
  unsigned mask = 0, value = 0;
};
Fixed fixed_bits(const char* pattern) {
  Fixed fixed;
  for (; *pattern; ++pattern) {
    if (*pattern == ' ') continue;
    fixed.mask = 2 * fixed.mask + (*pattern == '0' || *pattern == '1' ? 1 : 0);
    fixed.value = 2 * fixed.value + (*pattern == '1' ? 1 : 0);
  }
  return fixed;
}

}  // namespace

struct ManualModel::Code {
  OpcodeRow row;
  int cycles;       ///< with a program counter of 16 bits
  int long_cycles;  ///< with a program counter of 22 bits
  void (*run)(ManualModel& m);
};

// clang-format off
#define RUN [](ManualModel& m)
#define D m.data[m.field('d')]
#define R m.data[m.field('r')]
#define D16 m.data[16 + m.field('d')]
#define K static_cast<std::uint8_t>(m.field('K'))
#define IO static_cast<std::uint16_t>(0x20 + m.field('A'))
#define B m.field('b')
const ManualModel::Code& ManualModel::code_of(std::size_t index) {
  static const Code kCodes[] = {
    {{"ADD", "0000 11rd dddd rrrr"}, 1, 1, RUN { D = m.add(D, R, false); }},
    {{"ADC", "0001 11rd dddd rrrr"}, 1, 1, RUN { D = m.add(D, R, m.flag('C')); }},
    {{"SUB", "0001 10rd dddd rrrr"}, 1, 1, RUN { D = m.subtract(D, R, false, false); }},
    {{"SBC", "0000 10rd dddd rrrr"}, 1, 1, RUN { D = m.subtract(D, R, m.flag('C'), true); }},
    {{"AND", "0010 00rd dddd rrrr"}, 1, 1, RUN { m.logic(m.field('d'), D & R); }},
    {{"OR", "0010 10rd dddd rrrr"}, 1, 1, RUN { m.logic(m.field('d'), D | R); }},
    {{"EOR", "0010 01rd dddd rrrr"}, 1, 1, RUN { m.logic(m.field('d'), D ^ R); }},
    {{"MOV", "0010 11rd dddd rrrr"}, 1, 1, RUN { D = R; }},
    {{"CP", "0001 01rd dddd rrrr"}, 1, 1, RUN { m.subtract(D, R, false, false); }},
    {{"CPC", "0000 01rd dddd rrrr"}, 1, 1, RUN { m.subtract(D, R, m.flag('C'), true); }},
    {{"CPSE", "0001 00rd dddd rrrr"}, 1, 1, RUN { m.skip_if(D == R); }},
    {{"MUL", "1001 11rd dddd rrrr"}, 2, 2, RUN { m.multiply(D, R, false); }},
    {{"MULS", "0000 0010 dddd rrrr"}, 2, 2, RUN {
      m.multiply(static_cast<std::int8_t>(D16), static_cast<std::int8_t>(m.data[16 + m.field('r')]), false); }},
    {{"MULSU", "0000 0011 0ddd 0rrr"}, 2, 2, RUN {
      m.multiply(static_cast<std::int8_t>(D16), m.data[16 + m.field('r')], false); }},
    {{"FMUL", "0000 0011 0ddd 1rrr"}, 2, 2, RUN { m.multiply(D16, m.data[16 + m.field('r')], true); }},
    {{"FMULS", "0000 0011 1ddd 0rrr"}, 2, 2, RUN {
      m.multiply(static_cast<std::int8_t>(D16), static_cast<std::int8_t>(m.data[16 + m.field('r')]), true); }},
    {{"FMULSU", "0000 0011 1ddd 1rrr"}, 2, 2, RUN {
      m.multiply(static_cast<std::int8_t>(D16), m.data[16 + m.field('r')], true); }},
    {{"MOVW", "0000 0001 dddd rrrr"}, 1, 1, RUN {
      m.set_word(static_cast<std::uint16_t>(2 * m.field('d')), m.word(static_cast<std::uint16_t>(2 * m.field('r')))); }},

    {{"SUBI", "0101 KKKK dddd KKKK"}, 1, 1, RUN { D16 = m.subtract(D16, K, false, false); }},
    {{"SBCI", "0100 KKKK dddd KKKK"}, 1, 1, RUN { D16 = m.subtract(D16, K, m.flag('C'), true); }},
    {{"ANDI", "0111 KKKK dddd KKKK"}, 1, 1, RUN { m.logic(16 + m.field('d'), D16 & K); }},
    {{"ORI", "0110 KKKK dddd KKKK"}, 1, 1, RUN { m.logic(16 + m.field('d'), D16 | K); }},
    {{"LDI", "1110 KKKK dddd KKKK"}, 1, 1, RUN { D16 = K; }},
    {{"CPI", "0011 KKKK dddd KKKK"}, 1, 1, RUN { m.subtract(D16, K, false, false); }},
    {{"ADIW", "1001 0110 KKdd KKKK"}, 2, 2, RUN {
      const auto at = static_cast<std::uint16_t>(24 + 2 * m.field('d'));
      const std::uint16_t d = m.word(at), r = static_cast<std::uint16_t>(d + m.field('K'));
      m.set_word(at, r);
      m.set_flag('V', !bit(d, 15) && bit(r, 15));
      m.set_flag('N', bit(r, 15));
      m.set_flag('Z', r == 0);
      m.set_flag('C', !bit(r, 15) && bit(d, 15));
      m.set_sign(); }},
    {{"SBIW", "1001 0111 KKdd KKKK"}, 2, 2, RUN {
      const auto at = static_cast<std::uint16_t>(24 + 2 * m.field('d'));
      const std::uint16_t d = m.word(at), r = static_cast<std::uint16_t>(d - m.field('K'));
      m.set_word(at, r);
      m.set_flag('V', !bit(r, 15) && bit(d, 15));
      m.set_flag('N', bit(r, 15));
      m.set_flag('Z', r == 0);
      m.set_flag('C', bit(r, 15) && !bit(d, 15));
      m.set_sign(); }},

    {{"COM", "1001 010d dddd 0000"}, 1, 1, RUN { m.logic(m.field('d'), 0xFFu - D); m.set_flag('C', true); }},
    {{"NEG", "1001 010d dddd 0001"}, 1, 1, RUN {
      const std::uint8_t d = D, r = static_cast<std::uint8_t>(0 - d);
      D = r;
      m.set_flag('H', bit(r, 3) || bit(d, 3));
      m.set_flag('V', r == 0x80);
      m.set_flag('C', r != 0);
      m.set_zero_and_negative(r);
      m.set_sign(); }},
    {{"SWAP", "1001 010d dddd 0010"}, 1, 1, RUN { D = static_cast<std::uint8_t>(D % 16 * 16 + D / 16); }},
    {{"INC", "1001 010d dddd 0011"}, 1, 1, RUN {
      const auto r = static_cast<std::uint8_t>(D + 1);
      D = r;
      m.set_flag('V', r == 0x80);
      m.set_zero_and_negative(r);
      m.set_sign(); }},
    {{"ASR", "1001 010d dddd 0101"}, 1, 1, RUN { m.shift(bit(D, 7)); }},
    {{"LSR", "1001 010d dddd 0110"}, 1, 1, RUN { m.shift(false); }},
    {{"ROR", "1001 010d dddd 0111"}, 1, 1, RUN { m.shift(m.flag('C')); }},
    {{"DEC", "1001 010d dddd 1010"}, 1, 1, RUN {
      const auto r = static_cast<std::uint8_t>(D - 1);
      D = r;
      m.set_flag('V', r == 0x7F);
      m.set_zero_and_negative(r);
      m.set_sign(); }},
    {{"BLD", "1111 100d dddd 0bbb"}, 1, 1, RUN {
      D = static_cast<std::uint8_t>((D & ~(1u << B)) | (m.flag('T') ? 1u << B : 0u)); }},
    {{"BST", "1111 101d dddd 0bbb"}, 1, 1, RUN { m.set_flag('T', bit(D, B)); }},
    {{"PUSH", "1001 001r rrrr 1111"}, 2, 2, RUN { m.push(R); }},
    {{"POP", "1001 000d dddd 1111"}, 2, 2, RUN { D = m.pop(); }},

    {{"LD X", "1001 000d dddd 1100"}, 2, 2, RUN { D = m.data[m.word(kX)]; }},
    {{"LD X+", "1001 000d dddd 1101"}, 2, 2, RUN { D = m.data[m.word(kX)]; m.set_word(kX, m.word(kX) + 1u); }},
    {{"LD -X", "1001 000d dddd 1110"}, 2, 2, RUN { m.set_word(kX, m.word(kX) - 1u); D = m.data[m.word(kX)]; }},
    {{"LDD Y", "10q0 qq0d dddd 1qqq"}, 2, 2, RUN {
      D = m.data[static_cast<std::uint16_t>(m.word(kY) + m.field('q'))]; }},
    {{"LD Y+", "1001 000d dddd 1001"}, 2, 2, RUN { D = m.data[m.word(kY)]; m.set_word(kY, m.word(kY) + 1u); }},
    {{"LD -Y", "1001 000d dddd 1010"}, 2, 2, RUN { m.set_word(kY, m.word(kY) - 1u); D = m.data[m.word(kY)]; }},
    {{"LDD Z", "10q0 qq0d dddd 0qqq"}, 2, 2, RUN {
      D = m.data[static_cast<std::uint16_t>(m.word(kZ) + m.field('q'))]; }},
    {{"LD Z+", "1001 000d dddd 0001"}, 2, 2, RUN { D = m.data[m.word(kZ)]; m.set_word(kZ, m.word(kZ) + 1u); }},
    {{"LD -Z", "1001 000d dddd 0010"}, 2, 2, RUN { m.set_word(kZ, m.word(kZ) - 1u); D = m.data[m.word(kZ)]; }},
    {{"LDS", "1001 000d dddd 0000", 2}, 2, 2, RUN { D = m.data[m.second_]; }},
    {{"ST X", "1001 001r rrrr 1100"}, 2, 2, RUN { m.data[m.word(kX)] = R; }},
    {{"ST X+", "1001 001r rrrr 1101"}, 2, 2, RUN {
      const std::uint16_t at = m.word(kX); m.set_word(kX, at + 1u); m.data[at] = R; }},
    {{"ST -X", "1001 001r rrrr 1110"}, 2, 2, RUN { m.set_word(kX, m.word(kX) - 1u); m.data[m.word(kX)] = R; }},
    {{"STD Y", "10q0 qq1r rrrr 1qqq"}, 2, 2, RUN {
      m.data[static_cast<std::uint16_t>(m.word(kY) + m.field('q'))] = R; }},
    {{"ST Y+", "1001 001r rrrr 1001"}, 2, 2, RUN {
      const std::uint16_t at = m.word(kY); m.set_word(kY, at + 1u); m.data[at] = R; }},
    {{"ST -Y", "1001 001r rrrr 1010"}, 2, 2, RUN { m.set_word(kY, m.word(kY) - 1u); m.data[m.word(kY)] = R; }},
    {{"STD Z", "10q0 qq1r rrrr 0qqq"}, 2, 2, RUN {
      m.data[static_cast<std::uint16_t>(m.word(kZ) + m.field('q'))] = R; }},
    {{"ST Z+", "1001 001r rrrr 0001"}, 2, 2, RUN {
      const std::uint16_t at = m.word(kZ); m.set_word(kZ, at + 1u); m.data[at] = R; }},
    {{"ST -Z", "1001 001r rrrr 0010"}, 2, 2, RUN { m.set_word(kZ, m.word(kZ) - 1u); m.data[m.word(kZ)] = R; }},
    {{"STS", "1001 001r rrrr 0000", 2}, 2, 2, RUN { m.data[m.second_] = R; }},

    {{"LPM", "1001 0101 1100 1000"}, 3, 3, RUN { m.data[0] = m.program_byte(m.word(kZ)); }},
    {{"LPM Z", "1001 000d dddd 0100"}, 3, 3, RUN { D = m.program_byte(m.word(kZ)); }},
    {{"LPM Z+", "1001 000d dddd 0101"}, 3, 3, RUN {
      D = m.program_byte(m.word(kZ)); m.set_word(kZ, m.word(kZ) + 1u); }},
    {{"ELPM", "1001 0101 1101 1000"}, 3, 3, RUN {
      m.data[0] = m.program_byte(m.data[kRampz] * 0x10000u + m.word(kZ)); }},
    {{"ELPM Z", "1001 000d dddd 0110"}, 3, 3, RUN {
      D = m.program_byte(m.data[kRampz] * 0x10000u + m.word(kZ)); }},
    {{"ELPM Z+", "1001 000d dddd 0111"}, 3, 3, RUN {
      const std::uint32_t at = m.data[kRampz] * 0x10000u + m.word(kZ);
      D = m.program_byte(at);
      m.set_word(kZ, at + 1);
      m.data[kRampz] = static_cast<std::uint8_t>((at + 1) >> 16); }},

    {{"IN", "1011 0AAd dddd AAAA"}, 1, 1, RUN { D = m.data[IO]; }},
    {{"OUT", "1011 1AAr rrrr AAAA"}, 1, 1, RUN { m.data[IO] = R; }},
    {{"SBI", "1001 1010 AAAA Abbb"}, 2, 2, RUN { m.data[IO] = static_cast<std::uint8_t>(m.data[IO] | 1u << B); }},
    {{"CBI", "1001 1000 AAAA Abbb"}, 2, 2, RUN { m.data[IO] = static_cast<std::uint8_t>(m.data[IO] & ~(1u << B)); }},
    {{"SBIC", "1001 1001 AAAA Abbb"}, 1, 1, RUN { m.skip_if(!bit(m.data[IO], B)); }},
    {{"SBIS", "1001 1011 AAAA Abbb"}, 1, 1, RUN { m.skip_if(bit(m.data[IO], B)); }},

    {{"RJMP", "1100 kkkk kkkk kkkk"}, 2, 2, RUN { m.pc = m.relative(m.field('k'), 12); }},
    {{"RCALL", "1101 kkkk kkkk kkkk"}, 3, 4, RUN { m.call(m.relative(m.field('k'), 12)); }},
    {{"JMP", "1001 010k kkkk 110k", 2}, 3, 3, RUN { m.pc = m.field('k') * 0x10000u + m.second_; }},
    {{"CALL", "1001 010k kkkk 111k", 2}, 4, 5, RUN { m.call(m.field('k') * 0x10000u + m.second_); }},
    {{"IJMP", "1001 0100 0000 1001"}, 2, 2, RUN { m.pc = m.word(kZ); }},
    {{"ICALL", "1001 0101 0000 1001"}, 3, 4, RUN { m.call(m.word(kZ)); }},
    {{"EIJMP", "1001 0100 0001 1001"}, 2, 2, RUN { m.pc = m.data[kEind] * 0x10000u + m.word(kZ); }},
    {{"EICALL", "1001 0101 0001 1001"}, 4, 4, RUN { m.call(m.data[kEind] * 0x10000u + m.word(kZ)); }},
    {{"RET", "1001 0101 0000 1000"}, 4, 5, RUN { m.return_from_call(); }},
    {{"RETI", "1001 0101 0001 1000"}, 4, 5, RUN { m.return_from_call(); m.set_flag('I', true); }},
    {{"BRBS", "1111 00kk kkkk ksss"}, 1, 1, RUN { m.branch_if(bit(m.data[kSreg], m.field('s'))); }},
    {{"BRBC", "1111 01kk kkkk ksss"}, 1, 1, RUN { m.branch_if(!bit(m.data[kSreg], m.field('s'))); }},
    {{"SBRC", "1111 110r rrrr 0bbb"}, 1, 1, RUN { m.skip_if(!bit(R, B)); }},
    {{"SBRS", "1111 111r rrrr 0bbb"}, 1, 1, RUN { m.skip_if(bit(R, B)); }},

    {{"BSET", "1001 0100 0sss 1000"}, 1, 1, RUN {
      m.data[kSreg] = static_cast<std::uint8_t>(m.data[kSreg] | 1u << m.field('s')); }},
    {{"BCLR", "1001 0100 1sss 1000"}, 1, 1, RUN {
      m.data[kSreg] = static_cast<std::uint8_t>(m.data[kSreg] & ~(1u << m.field('s'))); }},
    {{"NOP", "0000 0000 0000 0000"}, 1, 1, RUN { static_cast<void>(m); }},
    {{"SLEEP", "1001 0101 1000 1000"}, 1, 1, RUN { static_cast<void>(m); }},
    {{"WDR", "1001 0101 1010 1000"}, 1, 1, RUN { static_cast<void>(m); }},
  };
  static constexpr Code kEnd{};
  return index < std::size(kCodes) ? kCodes[index] : kEnd;
}
// clang-format on

std::span<const OpcodeRow> ManualModel::rows() {
  static const std::vector<OpcodeRow> all = [] {
    std::vector<OpcodeRow> made;
    while (code_of(made.size()).run) made.push_back(code_of(made.size()).row);
    return made;
  }();
  return all;
}

std::optional<std::size_t> ManualModel::row_of(std::uint16_t word) {
  static constexpr std::uint8_t kReserved = 0xFF;
  static const std::vector<std::uint8_t> by_word = [] {
    std::vector<std::uint8_t> made(0x10000, kReserved);
    for (std::size_t row = 0; row < rows().size(); ++row) {
      const Fixed fixed = fixed_bits(rows()[row].pattern);
      for (unsigned opcode = 0; opcode < made.size(); ++opcode)
        if ((opcode & fixed.mask) == fixed.value) made[opcode] = static_cast<std::uint8_t>(row);
    }
    return made;
  }();
  const std::uint8_t row = by_word[word];
  if (row == kReserved) return std::nullopt;
  return row;
}

ManualModel::ManualModel(std::vector<std::uint16_t> words, bool long_pc)
    : flash(std::move(words)), ran(rows().size()), jumped(rows().size()), long_pc_(long_pc) {}

bool ManualModel::step() {
  if (pc >= flash.size()) return false;
  const auto row = row_of(flash[pc]);
  if (!row) return false;
  const Code& code = code_of(*row);
  opcode_ = flash[pc];
  pattern_ = code.row.pattern;
  if (code.row.words == 2) second_ = flash[(pc + 1) % flash.size()];
  pc += static_cast<std::uint32_t>(code.row.words);
  const std::uint32_t next = pc;
  cycles += static_cast<std::uint64_t>(long_pc_ ? code.long_cycles : code.cycles);
  code.run(*this);
  ++ran[*row];
  if (pc != next) ++jumped[*row];
  return true;
}

unsigned ManualModel::field(char letter) const {
  unsigned value = 0, number = 16;
  for (const char* digit = pattern_; *digit; ++digit) {
    if (*digit == ' ') continue;
    --number;
    if (*digit == letter) value = value * 2 + bit(opcode_, number);
  }
  return value;
}

bool ManualModel::flag(char name) const {
  constexpr const char* kNames = "CZNVSHTI";
  return bit(data[kSreg], static_cast<unsigned>(std::strchr(kNames, name) - kNames));
}

void ManualModel::set_flag(char name, bool value) {
  constexpr const char* kNames = "CZNVSHTI";
  const unsigned mask = 1u << (std::strchr(kNames, name) - kNames);
  data[kSreg] = static_cast<std::uint8_t>(value ? data[kSreg] | mask : data[kSreg] & ~mask);
}

void ManualModel::set_zero_and_negative(std::uint8_t result) {
  set_flag('N', bit(result, 7));
  set_flag('Z', result == 0);
}

std::uint8_t ManualModel::add(std::uint8_t d, std::uint8_t r, bool carry) {
  const auto sum = static_cast<std::uint8_t>(d + r + (carry ? 1 : 0));
  const bool d3 = bit(d, 3), r3 = bit(r, 3), s3 = bit(sum, 3), d7 = bit(d, 7), r7 = bit(r, 7),
             s7 = bit(sum, 7);
  set_flag('H', (d3 && r3) || (r3 && !s3) || (!s3 && d3));
  set_flag('V', (d7 && r7 && !s7) || (!d7 && !r7 && s7));
  set_zero_and_negative(sum);
  set_flag('C', (d7 && r7) || (r7 && !s7) || (!s7 && d7));
  set_sign();
  return sum;
}

std::uint8_t ManualModel::subtract(std::uint8_t d, std::uint8_t r, bool carry, bool keeps_zero) {
  const auto rest = static_cast<std::uint8_t>(d - r - (carry ? 1 : 0));
  const bool d3 = bit(d, 3), r3 = bit(r, 3), s3 = bit(rest, 3), d7 = bit(d, 7), r7 = bit(r, 7),
             s7 = bit(rest, 7);
  const bool zero_before = flag('Z');
  set_flag('H', (!d3 && r3) || (r3 && s3) || (s3 && !d3));
  set_flag('V', (d7 && !r7 && !s7) || (!d7 && r7 && s7));
  set_zero_and_negative(rest);
  if (keeps_zero) set_flag('Z', rest == 0 && zero_before);
  set_flag('C', (!d7 && r7) || (r7 && s7) || (s7 && !d7));
  set_sign();
  return rest;
}

void ManualModel::logic(unsigned d, unsigned result) {
  data[d] = static_cast<std::uint8_t>(result);
  set_flag('V', false);
  set_zero_and_negative(data[d]);
  set_sign();
}

void ManualModel::shift(bool top) {
  std::uint8_t& d = data[field('d')];
  set_flag('C', bit(d, 0));
  d = static_cast<std::uint8_t>(d / 2 + (top ? 0x80 : 0));
  set_zero_and_negative(d);
  set_flag('V', flag('N') != flag('C'));
  set_sign();
}

void ManualModel::multiply(int a, int b, bool fractional) {
  const auto product = static_cast<std::uint16_t>(a * b);
  set_flag('C', bit(product, 15));
  const auto result = static_cast<std::uint16_t>(fractional ? product * 2 : product);
  set_flag('Z', result == 0);
  set_word(0, result);
}

void ManualModel::push(unsigned value) {
  const std::uint16_t at = sp();
  data[at] = static_cast<std::uint8_t>(value);
  set_sp(static_cast<std::uint16_t>(at - 1));
}

std::uint8_t ManualModel::pop() {
  set_sp(static_cast<std::uint16_t>(sp() + 1));
  return data[sp()];
}

void ManualModel::call(std::uint32_t target) {
  push(pc);
  push(pc >> 8);
  if (long_pc_) push(pc >> 16);
  pc = target;
}

void ManualModel::return_from_call() {
  std::uint32_t to = long_pc_ ? pop() : 0;
  to = to * 0x100 + pop();
  pc = to * 0x100 + pop();
}

void ManualModel::skip_if(bool condition) {
  if (!condition) return;
  const auto next = row_of(flash[pc % flash.size()]);
  const int words = next ? rows()[*next].words : 1;
  pc += static_cast<std::uint32_t>(words);
  cycles += static_cast<std::uint64_t>(words);
}

void ManualModel::branch_if(bool condition) {
  if (!condition) return;
  pc = relative(field('k'), 7);
  cycles += 1;
}

std::uint8_t ManualModel::program_byte(std::uint32_t address) const {
  const std::uint16_t word = flash[address / 2 % flash.size()];
  return static_cast<std::uint8_t>(address % 2 ? word >> 8 : word);
}

std::uint32_t ManualModel::relative(unsigned k, int bits) const {
  const std::uint32_t size = 1u << bits;
  const std::uint32_t distance = k < size / 2 ? k : k - size;
  return (pc + distance) % static_cast<std::uint32_t>(flash.size());
}

}  // namespace robosim::avr
