// Handles divisions by zero in a sketch for the host. An AVR and a Cortex-M3 continue after one; an x86-64
// raises a signal, and an arm64 gives another result. So each division instruction in gcc's assembly is
// extended to give the chip's result.
//
//   chip       quotient                             remainder      source
//   AVR        all bits 1; 1 if dividend < 0        the dividend   libgcc, config/avr/lib1funcs.S: shift and
//                                                                  subtract, then the sign
//   Cortex-M3  0                                    the dividend   DDI 0403E, A7.7.127 (SDIV), CCR.DIV_0_TRP;
//                                                                  its library for 64 bits gives other values
//
// The most negative number divided by -1 is itself on both. 32-bit ARM has no instruction to divide: its
// library function is wrapped (hal/host/division.cpp).
//
// arm64 has no 16-bit division. gcc uses that of 32 bits and does not truncate its result, which fits except
// after a division by zero. So a uint16_t divided by zero may be -1 there, instead of 65535, until it is
// stored.
#pragma once

#include <string>
#include <string_view>

#include "hal/board/board_spec.h"

namespace robosim::build {

enum class QuotientByZero { all_ones, zero };

/// Returns the quotient that the chip of `board` gives.
QuotientByZero quotient_by_zero(const BoardSpec& board);

/// Returns lines that replace one line of gcc's assembly and give the chip's result if the divisor is
/// zero; empty if the line is not a division of x86-64 (AT&T syntax) or arm64. `number` must
/// differ between the divisions of a file: it goes into their labels. The operands are those that gcc writes;
/// no line depends on how the assembler expands a macro.
std::string division_of_chip(std::string_view line, QuotientByZero quotient, int number);

}  // namespace robosim::build
