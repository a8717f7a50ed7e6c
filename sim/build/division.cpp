#include "sim/build/division.h"

#include <fmt/format.h>

namespace robosim::build {
namespace {

#if defined(__x86_64__)

// The macros' own instruction follows a pseudo-prefix, so that it is not taken for a macro again.
constexpr std::string_view kMacros = R"(
.macro robosim_divide size, low, high, top, with_sign, divide, by:vararg
	cmp\size	$0, \by
	jne	.Lrobosim_divides\@
	mov\size	%\low, %\high
.if robosim_ones_by_zero == 0
	mov\size	$0, %\low
.elseif \with_sign
	sar\size	$\top, %\low
	add\size	%\low, %\low
	not\size	%\low
.else
	mov\size	$-1, %\low
.endif
	jmp	.Lrobosim_divided\@
.Lrobosim_divides\@:
.if \with_sign
	cmp\size	$-1, \by
	jne	.Lrobosim_fits\@
	neg\size	%\low
	mov\size	$0, %\high
	jmp	.Lrobosim_divided\@
.Lrobosim_fits\@:
.endif
	{load} \divide\size \by
.Lrobosim_divided\@:
.endm
.macro idivb by:vararg
	robosim_divide	b, al, ah, 7, 1, idiv, \by
.endm
.macro idivw by:vararg
	robosim_divide	w, ax, dx, 15, 1, idiv, \by
.endm
.macro idivl by:vararg
	robosim_divide	l, eax, edx, 31, 1, idiv, \by
.endm
.macro idivq by:vararg
	robosim_divide	q, rax, rdx, 63, 1, idiv, \by
.endm
.macro divb by:vararg
	robosim_divide	b, al, ah, 7, 0, div, \by
.endm
.macro divw by:vararg
	robosim_divide	w, ax, dx, 15, 0, div, \by
.endm
.macro divl by:vararg
	robosim_divide	l, eax, edx, 31, 0, div, \by
.endm
.macro divq by:vararg
	robosim_divide	q, rax, rdx, 63, 0, div, \by
.endm
)";

#elif defined(__aarch64__)

// Of the macros' own instruction only the code can be written, or it were taken for a macro again.
constexpr std::string_view kMacros = R"(
.irp number, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30
.set .Lrobosim_number_w\number, \number
.set .Lrobosim_number_x\number, \number
.set .Lrobosim_top_w\number, 31
.set .Lrobosim_top_x\number, 63
.endr
.set .Lrobosim_number_wzr, 31
.set .Lrobosim_number_xzr, 31
.set .Lrobosim_top_wzr, 31
.set .Lrobosim_top_xzr, 63
.macro robosim_divide with_sign, quotient, dividend, divisor
	cbnz	\divisor, .Lrobosim_divides\@
.if robosim_ones_by_zero == 0
	mov	\quotient, 0
.elseif \with_sign
	asr	\quotient, \dividend, #.Lrobosim_top_\quotient
	mvn	\quotient, \quotient, lsl #1
.else
	mov	\quotient, -1
.endif
	b	.Lrobosim_divided\@
.Lrobosim_divides\@:
	.inst	(.Lrobosim_top_\quotient / 32 << 31) | 0x1ac00800 | (\with_sign << 10) | (.Lrobosim_number_\divisor << 16) | (.Lrobosim_number_\dividend << 5) | .Lrobosim_number_\quotient
.Lrobosim_divided\@:
.endm
.macro sdiv quotient, dividend, divisor
	robosim_divide	1, \quotient, \dividend, \divisor
.endm
.macro udiv quotient, dividend, divisor
	robosim_divide	0, \quotient, \dividend, \divisor
.endm
)";

#else

constexpr std::string_view kMacros = "";

#endif

}  // namespace

QuotientByZero quotient_by_zero(const BoardSpec& board) {
  return std::string_view(board.chip->target) == "stm32" ? QuotientByZero::zero : QuotientByZero::all_ones;
}

std::string with_division_of_chip(std::string_view assembly, QuotientByZero quotient) {
  return fmt::format("\t.set\trobosim_ones_by_zero, {}{}{}", quotient == QuotientByZero::all_ones ? 1 : 0,
                     kMacros.empty() ? "\n" : kMacros, assembly);
}

}  // namespace robosim::build
