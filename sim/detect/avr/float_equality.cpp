#include "sim/detect/avr/float_equality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/mcu/avr/instruction_table.h"

namespace robosim::detect::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Instruction;
using robosim::avr::Op;

constexpr std::uint8_t kLeft = 22, kRight = 18, kResult = 24, kZero = 1;  // registers
constexpr std::uint8_t kFlagZ = 2;
constexpr std::uint32_t kWordsOfTest = 6;  // largest distance from a call to the test of its result
constexpr int kMany = 10, kLongAway = 20;

float float_of(std::uint32_t bits) {
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Returns whether the result of the call before word address `pc` is tested for 0, not for its sign.
bool is_tested_for_zero(const robosim::avr::Cpu& cpu, std::uint32_t pc) {
  bool compared = false;  // the result was compared with 0
  for (const std::uint32_t end = pc + kWordsOfTest; pc < end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    const bool with_zero = (i.a == kResult && i.b == kZero) || (i.a == kZero && i.b == kResult);
    const Control control = control_of(i.op);
    if (control == Control::branch) return compared && i.b == kFlagZ;
    if (i.op == Op::cpse && with_zero) return true;
    if (control == Control::skip || control == Control::call) return false;
    compared = compared || (i.op == Op::and_ && i.a == kResult && i.b == kResult) ||
               (i.op == Op::cp && with_zero) || (i.op == Op::cpi && i.a == kResult && i.b == 0);
  }
  return false;
}

}  // namespace

FloatEquality::FloatEquality(const RunningProgram& program)
    : machine_(program.machine), debug_(program.debug) {
  const auto compares = program.firmware.find("__eqsf2");
  if (!compares) return;
  const robosim::avr::Cpu& cpu = machine_.chip().chip().cpu();
  const auto words = static_cast<std::uint32_t>(cpu.flash().size() / 2);
  for (std::uint32_t pc = 0; 2 * pc < program.firmware.code_end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    if (control_of(i.op) != Control::call || target_of(i, pc, words) != *compares / 2) continue;
    if (!is_tested_for_zero(cpu, pc + i.words)) continue;
    if (debug_.place(2 * pc).file.empty()) continue;
    comparisons_.push_back({2 * pc});
    program.machine.chip().show(*this, 2 * pc);
  }
}

void FloatEquality::visited(std::uint32_t pc, Cycle) {
  const auto at = std::lower_bound(comparisons_.begin(), comparisons_.end(), pc,
                                   [](const Comparison& one, std::uint32_t place) { return one.pc < place; });
  if (at->met) return;
  Comparison& one = *at;
  const auto number = [&](std::uint8_t first) {
    const auto& data = machine_.chip().chip().cpu().data;
    return static_cast<std::uint32_t>(data[first] | data[first + 1] << 8 | data[first + 2] << 16) |
           std::uint32_t{data[first + 3]} << 24;
  };
  const std::uint32_t left = number(kLeft), right = number(kRight);
  if (one.times++ == 0) one.left = left, one.right = right;
  one.left_varies = one.left_varies || left != one.left;
  one.right_varies = one.right_varies || right != one.right;
  const float apart = float_of(right) - float_of(left);
  one.met = apart == 0.0f || !std::isfinite(apart) || (one.left_varies && one.right_varies);
  if (one.met) {
    one.found_at = -1;
    return;
  }
  const bool passes = one.times > 1 && std::signbit(apart) != std::signbit(one.before);
  one.has_passed = one.has_passed || passes;
  one.away = passes || std::abs(apart) < std::abs(one.before) ? 0 : one.away + 1;
  one.before = apart;
  if (one.found_at >= 0 || !one.has_passed || one.times < kMany) return;
  if (constant(one) != 0.0f || one.away >= kLongAway) one.found_at = machine_.now();
}

float FloatEquality::constant(const Comparison& one) {
  return float_of(one.left_varies ? one.right : one.left);
}

std::vector<Detected> FloatEquality::found(SimTime) const {
  std::vector<Detected> all;
  for (const Comparison& one : comparisons_)
    if (one.found_at >= 0)
      all.push_back(
          {result::detector("float_equality"),
           fmt::format(
               "a measured or summed float rarely equals an exact value: this one was compared {1} times "
               "by == or != with {0:g}, passed it, and was never equal",
               constant(one), one.times),
           "Compare with >= or <=, or with fabs(a - b) < 0.5, or count in integers.", debug_.place(one.pc),
           1e-9 * static_cast<double>(one.found_at), one.times});
  return all;
}

}  // namespace robosim::detect::avr
