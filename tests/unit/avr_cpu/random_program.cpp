#include "tests/unit/avr_cpu/random_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "hal/board/atmega2560.h"
#include "hal/board/atmega328p.h"

namespace robosim::avr {
namespace {

constexpr Address kLastData = 0xFFFF, kFirstStack = 0x1000;
constexpr unsigned kSpl = 0x3D, kSph = 0x3E;  // I/O addresses
constexpr std::uint16_t kSpm = 0x95E8, kBreak = 0x9598, kPush16 = 0x930F, kToItself = 0xCFFF;

std::vector<std::uint8_t> bytes_of(const std::vector<std::uint16_t>& words) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint16_t word : words) {
    bytes.push_back(static_cast<std::uint8_t>(word));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8));
  }
  return bytes;
}

unsigned below(std::mt19937& random, unsigned count) { return static_cast<unsigned>(random() % count); }

std::uint16_t random_word(std::mt19937& random, const char* pattern) {
  unsigned word = 0;
  for (; *pattern; ++pattern)
    if (*pattern != ' ') word = 2 * word + (*pattern == '1' || (*pattern != '0' && below(random, 2)) ? 1 : 0);
  return static_cast<std::uint16_t>(word);
}

bool is_far(std::string_view name) { return name.starts_with("ELPM") || name.starts_with("EI"); }

/// Returns the low register of the pointer that the instruction increments or decrements; 0 = none.
unsigned moved_pointer(std::string_view name) {
  if (name.find('+') == name.npos && name.find('-') == name.npos) return 0;
  return name.find('X') != name.npos ? 26 : name.find('Y') != name.npos ? 28 : 30;
}

/// Returns whether the manual says "The result of these combinations is undefined", as for LD r26, X+.
bool moves_its_own_register(std::string_view name, unsigned word) {
  const unsigned pointer = moved_pointer(name), d = word >> 4 & 31;
  return pointer != 0 && (d == pointer || d == pointer + 1);
}

/// Draws one of the pairs of instructions that the processor executes in one step. Returns the second
/// instruction if the first one is `name`, otherwise `name`.
std::string_view partner_of(std::string_view name, std::mt19937& random) {
  constexpr std::string_view kPartners[][2] = {
      {"ADD", "ADC"}, {"SUB", "SBC"},  {"SUBI", "SBCI"}, {"CP", "CPC"},   {"CPI", "CPC"},
      {"LSR", "ROR"}, {"ASR", "ROR"},  {"CP", "BRBS"},   {"CPC", "BRBS"}, {"CPI", "BRBS"},
      {"CP", "BRBC"}, {"CPC", "BRBC"}, {"CPI", "BRBC"},  {"DEC", "BRBC"}, {"SUBI", "BRBC"}};
  const auto& [first, second] = kPartners[below(random, std::size(kPartners))];
  return name == first ? second : name;
}

/// Clears high bits of a JMP's or CALL's target, so that the target is in flash.
std::uint16_t within_flash(std::uint16_t word, bool long_pc) {
  return static_cast<std::uint16_t>(word & ~0x01F0u & (long_pc ? ~0u : ~1u));
}

}  // namespace

std::vector<std::uint16_t> random_flash(std::mt19937& random, bool long_pc) {
  const std::size_t size = long_pc ? 0x20000 : 0x10000;
  std::vector<std::uint16_t> flash;
  const auto ldi_16 = [&](unsigned value) {
    return static_cast<std::uint16_t>(0xE000 | value % 16 | value / 16 << 8);
  };
  const auto& rows = ManualModel::rows();
  std::string_view before;
  while (flash.size() < size - 4) {
    const std::string_view wanted = below(random, 3) == 0 ? partner_of(before, random) : "";
    const auto known =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == wanted; });
    const OpcodeRow& row =
        known != rows.end() ? *known : rows[below(random, static_cast<unsigned>(rows.size()))];
    const std::string_view name = before = row.name;
    std::uint16_t word = random_word(random, row.pattern);
    if (name == "JMP" || name == "CALL") word = within_flash(word, long_pc);
    if ((is_far(name) && !long_pc) || moves_its_own_register(name, word)) continue;
    const unsigned io = (word >> 5 & 48) | (word & 15);
    if (name == "OUT" && (io == kSpl || io == kSph) && below(random, 8) != 0) continue;
    if (long_pc && name.starts_with("RET")) {
      for (const unsigned value : {below(random, 256), below(random, 256), below(random, 2)}) {
        flash.push_back(ldi_16(value));
        flash.push_back(kPush16);
      }
    }
    flash.push_back(word);
    if (row.words == 2) flash.push_back(static_cast<std::uint16_t>(random()));
    if (name == "SBIW" && below(random, 2) == 0) {
      flash.back() = static_cast<std::uint16_t>(0x9701 | (word & 0x30));
      flash.push_back(0xF7F1);  // BRNE, back to the previous instruction
    }
  }
  flash.resize(size, kToItself);
  return flash;
}

Pair::Pair(std::mt19937& random, bool long_pc)
    : manual(random_flash(random, long_pc), long_pc),
      cpu(long_pc ? kAtmega2560 : kAtmega328p, bytes_of(manual.flash), kLastData),
      long_pc_(long_pc) {
  for (auto& byte : manual.data) byte = static_cast<std::uint8_t>(random());
  std::copy(manual.data.begin(), manual.data.end(), cpu.data.begin());
}

Start Pair::random_start(std::mt19937& random) const {
  Start start;
  for (auto& byte : start.registers) byte = static_cast<std::uint8_t>(random());
  start.sreg = static_cast<std::uint8_t>(random());
  start.sp = static_cast<std::uint16_t>(kFirstStack + below(random, 0xF000 - kFirstStack));
  start.pc = below(random, static_cast<unsigned>(manual.flash.size()));
  start.rampz = static_cast<std::uint8_t>(below(random, 4));
  start.eind = static_cast<std::uint8_t>(below(random, 2));
  return start;
}

void Pair::begin(const Start& start) {
  std::copy(start.registers.begin(), start.registers.end(), manual.data.begin());
  std::copy(start.registers.begin(), start.registers.end(), cpu.data.begin());
  manual.data[ManualModel::kSreg] = start.sreg;
  cpu.set_sreg(start.sreg);
  manual.set_sp(start.sp);
  cpu.set_sp(start.sp);
  cpu.state.sp_watch = 0;
  manual.data[ManualModel::kRampz] = cpu.data[ManualModel::kRampz] = start.rampz;
  manual.data[ManualModel::kEind] = cpu.data[ManualModel::kEind] = start.eind;
  manual.pc = start.pc;
  cpu.set_pc(start.pc);
}

bool Pair::is_undefined() const {
  if (manual.pc >= manual.flash.size()) return false;
  const auto row = ManualModel::row_of(manual.flash[manual.pc]);
  if (!row) return false;
  const std::string_view name = ManualModel::rows()[*row].name;
  const bool far_is_there =
      long_pc_ && manual.data[ManualModel::kRampz] < 4 && manual.data[ManualModel::kEind] < 2;
  if (is_far(name) && !far_is_there) return true;
  if (moves_its_own_register(name, manual.flash[manual.pc])) return true;
  const unsigned sp = manual.sp();
  if (sp > ManualModel::kRampz - 4 && sp < ManualModel::kSreg + 4) return true;
  const unsigned pointer = moved_pointer(name);
  if (pointer == 0) return false;
  const unsigned at = manual.data[pointer] | manual.data[pointer + 1] << 8;
  return at >= 25 && at <= 32;
}

bool Pair::run(int instructions) {
  bool goes_on = true;
  for (int i = 0; i < instructions && goes_on; ++i) goes_on = !is_undefined() && manual.step();
  const bool is_outside = manual.pc >= manual.flash.size();
  Cpu::Stop stop = Cpu::Stop::reached;
  while (cpu.cycle() < manual.cycles && (stop == Cpu::Stop::reached || stop == Cpu::Stop::sleep))
    stop = cpu.run(manual.cycles);
  if (!is_outside && (goes_on || is_undefined())) return goes_on;
  // The model has stopped, so the processor must stop at the same instruction.
  if (!is_outside && cpu.pc() != manual.pc) return false;
  const std::uint16_t word = is_outside ? std::uint16_t{0} : manual.flash[manual.pc];
  const Cpu::Stop due = is_outside       ? Cpu::Stop::outside
                        : word == kSpm   ? Cpu::Stop::spm
                        : word == kBreak ? Cpu::Stop::break_
                                         : Cpu::Stop::illegal;
  if (is_outside && cpu.outside_pc() != manual.pc) wrong_stop_ = "another target out of the flash";
  if (is_outside) cpu.set_pc(static_cast<std::uint32_t>(manual.flash.size()));
  if (cpu.run(cpu.cycle() + 1) != due) wrong_stop_ = fmt::format("no stop at {:04x}", word);
  cpu.set_pc(manual.pc);
  cpu.skip_to(manual.cycles);
  return false;
}

std::string Pair::difference() const {
  std::string text = wrong_stop_;
  const auto add = [&](const char* what, std::uint64_t ours, std::uint64_t due) {
    if (ours != due) text += fmt::format("{} {:x}, due {:x}; ", what, ours, due);
  };
  add("program counter", cpu.pc(), manual.pc);
  add("cycles", cpu.cycle(), manual.cycles);
  add("SREG", cpu.sreg(), manual.data[ManualModel::kSreg]);
  add("stack pointer", cpu.sp(), manual.sp());
  constexpr std::size_t kBehind = ManualModel::kSreg + 1;
  if (text.empty() && std::memcmp(cpu.data.data(), manual.data.data(), ManualModel::kSp) == 0 &&
      std::memcmp(cpu.data.data() + kBehind, manual.data.data() + kBehind, kLastData + 1u - kBehind) == 0)
    return "";
  for (std::size_t at = 0; at <= kLastData; ++at)
    if (at < ManualModel::kSp || at >= kBehind)
      add(fmt::format("memory at {:04x}", at).c_str(), cpu.data[at], manual.data[at]);
  return text;
}

}  // namespace robosim::avr
