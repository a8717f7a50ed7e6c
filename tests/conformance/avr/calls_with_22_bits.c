// A call pushes three bytes onto the stack, the highest at the lowest address; RCALL, ICALL and EICALL take 4
// cycles, CALL and RET 5.
// Source: DS40002198B, CALL, EICALL, ICALL, RCALL, RET
// Expect: 03 00 09 0a 09 09
// Chips: atmega2560
#include "report.h"

static uint8_t before, depth, top;

static void __attribute__((noinline, naked, used)) just_return(void) { __asm__ volatile("ret"); }
static void __attribute__((noinline)) look(void) {
  const uint8_t now = SPL;
  depth = (uint8_t)(before - now);
  top = *(volatile uint8_t*)(SP + 1);
}

// Returns the cycles of `instruction` and its RET, plus 1: OUT and IN alone are 1 cycle apart.
#define CYCLES(instruction)                                                         \
  ({                                                                                \
    uint8_t count;                                                                  \
    __asm__ volatile(                                                               \
        "ldi r30, pm_lo8(just_return)\n\tldi r31, pm_hi8(just_return)\n\tldi r24, " \
        "pm_hh8(just_return)\n\tout %2, r24\n\t"                                    \
        "ldi r24, 0\n\tout %1, r24\n\t" instruction "\n\tin %0, %1"                 \
        : "=r"(count)                                                               \
        : "I"(_SFR_IO_ADDR(TCNT0)), "I"(_SFR_IO_ADDR(EIND))                         \
        : "r24", "r30", "r31");                                                     \
    count;                                                                          \
  })

int main(void) {
  TCCR0B = _BV(CS00);
  before = SPL;
  look();
  report(depth);
  report(top);
  report(CYCLES("rcall just_return"));
  report(CYCLES("call just_return"));
  report(CYCLES("icall"));
  report(CYCLES("eicall"));
  end_program();
}
