// Divisions by zero in a sketch for the host. An AVR and a Cortex-M3 go on behind one, an x86-64 raises a
// signal and an arm64 gives its own result; so each division is made to give what the chip gives.
//
//   chip       quotient                             remainder      source
//   AVR        all bits 1; of negative numbers 1    the dividend   libgcc, config/avr/lib1funcs.S: shift and
//                                                                  subtract, then the sign
//   Cortex-M3  0                                    the dividend   DDI 0403E, A7.7.127 (SDIV), CCR.DIV_0_TRP;
//                                                                  of 64 bits its library gives other numbers
//
// The most negative number divided by -1 is itself on both. arm has no instruction to divide: its function is
// wrapped (hal/host/division.cpp).
//
// arm64 has none for 16 bits: gcc takes the one for 32 and does not cut its result, which fits but for a
// division by zero. So a uint16_t by a uint16_t may be -1 there, in place of 65535, until it is stored.
#pragma once

#include <string>
#include <string_view>

#include "hal/board/board_spec.h"

namespace robosim::build {

enum class QuotientByZero { all_ones, zero };

/// What the chip of `board` gives.
QuotientByZero quotient_by_zero(const BoardSpec& board);

/// `assembly` of gcc for x86-64 or arm64, behind macros in whose place the assembler reads its divisions.
std::string with_division_of_chip(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
