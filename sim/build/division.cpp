#include "sim/build/division.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
namespace robosim::build {
namespace {

struct Division {
  std::string_view instruction, operands;
  bool is_signed = false;
};

/// Returns the division in a line, if any. On x86-64, the last letter of the instruction's name is the
/// operand width.
std::optional<Division> division_in(std::string_view line) {
  const std::size_t space = line.find_first_of(" \t");
  if (space == line.npos) return std::nullopt;
  const std::string_view word = line.substr(0, space);
  const std::size_t operands = line.find_first_not_of(" \t", space);
  if (operands == line.npos) return std::nullopt;
  for (const std::string_view name :
       {"sdiv", "udiv", "idivb", "idivw", "idivl", "idivq", "divb", "divw", "divl", "divq"})
    if (word == name) return Division{word, line.substr(operands), word[0] == 's' || word[0] == 'i'};
  return std::nullopt;
}

/// The accumulator of an x86-64, for operands of one width. `low` contains the dividend and the quotient,
/// `high` the remainder.
struct Accumulator {
  char width;  ///< last letter of the instruction's name
  const char *low, *high;
  int sign_bit;
};

constexpr Accumulator kAccumulators[] = {
    {'b', "al", "ah", 7}, {'w', "ax", "dx", 15}, {'l', "eax", "edx", 31}, {'q', "rax", "rdx", 63}};

std::string division_of_x86(const Division& division, QuotientByZero quotient, int number) {
  const Accumulator* a = kAccumulators;
  while (a->width != division.instruction.back()) ++a;
  std::string text = fmt::format(
      "\tcmp{0}\t$0, {1}\n"
      "\tjne\t.Lrobosim_divides{2}\n"
      "\tmov{0}\t%{3}, %{4}\n",
      a->width, division.operands, number, a->low, a->high);
  if (quotient == QuotientByZero::zero)
    text += fmt::format("\tmov{}\t$0, %{}\n", a->width, a->low);
  else if (division.is_signed)
    text += fmt::format("\tsar{0}\t${2}, %{1}\n\tadd{0}\t%{1}, %{1}\n\tnot{0}\t%{1}\n", a->width, a->low,
                        a->sign_bit);
  else
    text += fmt::format("\tmov{}\t$-1, %{}\n", a->width, a->low);
  text += fmt::format("\tjmp\t.Lrobosim_divided{0}\n.Lrobosim_divides{0}:\n", number);
  if (division.is_signed)  // a division by -1 may overflow, and the processor raises a signal
    text += fmt::format(
        "\tcmp{0}\t$-1, {1}\n"
        "\tjne\t.Lrobosim_fits{2}\n"
        "\tneg{0}\t%{3}\n"
        "\tmov{0}\t$0, %{4}\n"
        "\tjmp\t.Lrobosim_divided{2}\n"
        ".Lrobosim_fits{2}:\n",
        a->width, division.operands, number, a->low, a->high);
  return text +
         fmt::format("\t{}\t{}\n.Lrobosim_divided{}:\n", division.instruction, division.operands, number);
}

/// Splits "w0, w1, w2". Returns nothing if the operands are not three registers of one width.
std::optional<std::array<std::string_view, 3>> three_registers(std::string_view operands) {
  std::array<std::string_view, 3> registers;
  for (std::size_t i = 0; i < registers.size(); ++i) {
    const std::size_t comma = operands.find(',');
    if ((comma == operands.npos) != (i == 2)) return std::nullopt;
    registers[i] = operands.substr(0, comma);
    if (registers[i].empty() || registers[i][0] != registers[0][0]) return std::nullopt;
    operands.remove_prefix(std::min(operands.find_first_not_of(", ", comma), operands.size()));
  }
  return registers[0][0] == 'w' || registers[0][0] == 'x' ? std::optional(registers) : std::nullopt;
}

std::string division_of_arm64(const Division& division, QuotientByZero quotient, int number) {
  const auto registers = three_registers(division.operands);
  if (!registers) return "";
  const auto& [result, dividend, divisor] = *registers;
  std::string text = fmt::format("\tcbnz\t{}, .Lrobosim_divides{}\n", divisor, number);
  if (quotient == QuotientByZero::zero)
    text += fmt::format("\tmov\t{}, 0\n", result);
  else if (division.is_signed)
    text += fmt::format("\tasr\t{0}, {1}, #{2}\n\tmvn\t{0}, {0}, lsl #1\n", result, dividend,
                        result[0] == 'w' ? 31 : 63);
  else
    text += fmt::format("\tmov\t{}, -1\n", result);
  return text + fmt::format(
                    "\tb\t.Lrobosim_divided{0}\n"
                    ".Lrobosim_divides{0}:\n"
                    "\t{1}\t{2}\n"
                    ".Lrobosim_divided{0}:\n",
                    number, division.instruction, division.operands);
}

}  // namespace

QuotientByZero quotient_by_zero(const BoardSpec& board) {
  return std::string_view(board.chip->target) == "stm32" ? QuotientByZero::zero : QuotientByZero::all_ones;
}

std::string division_of_chip(std::string_view line, QuotientByZero quotient, int number) {
  const std::optional<Division> division = division_in(line);
  if (!division) return "";
  const bool arm64 = division->instruction == "sdiv" || division->instruction == "udiv";
  return arm64 ? division_of_arm64(*division, quotient, number)
               : division_of_x86(*division, quotient, number);
}

}  // namespace robosim::build
