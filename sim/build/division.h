// Handles divisions by zero in a sketch for the host. After such a division, an AVR and a Cortex-M3 continue.
// An x86-64 raises a signal, and an arm64 gives another result. Each division instruction in gcc's assembly
// is therefore extended to give the chip's result.
//
//   chip       quotient                             remainder      source
//   AVR        all bits 1; 1 if dividend < 0        the dividend   libgcc, config/avr/lib1funcs.S: shift and
//                                                                  subtract, then the sign
//   Cortex-M3  0                                    the dividend   DDI 0403E, A7.7.127 (SDIV), CCR.DIV_0_TRP;
//                                                                  64-bit library functions give other values
//
// On both chips, the most negative number divided by -1 gives the same number again. A 32-bit ARM host has no
// division instruction, so its library function is wrapped (hal/host/division.cpp).
//
// arm64 has no 16-bit division. gcc uses the 32-bit division, and does not truncate the result: it fits in 16
// bits, except after a division by zero. On arm64, a uint16_t divided by zero may therefore be -1 instead of
// 65535, until the result is stored.
#pragma once

#include <string>
#include <string_view>

#include "hal/board/board_spec.h"

namespace robosim::build {

enum class QuotientByZero { all_ones, zero };

/// Returns the quotient that the chip of `board` computes.
QuotientByZero quotient_by_zero(const BoardSpec& board);

/// Returns lines that replace a division in gcc's assembly and give the chip's result if the divisor is zero.
/// Returns an empty text if the line is not a division of x86-64 (AT&T syntax) or arm64. `number` is part of
/// the labels and must differ between the divisions of a file. The operands remain as gcc wrote them. The
/// lines contain no assembler macros, because versions of the assembler expand macros differently.
std::string division_of_chip(std::string_view line, QuotientByZero quotient, int number);

}  // namespace robosim::build
