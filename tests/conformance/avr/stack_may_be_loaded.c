// SP may point anywhere: two routines with their own stacks alternate, and calls and interrupts use the
// current stack.
// Source: DS40002061B, 7.5; DS40002198B, CALL, RET
// Expect: a1 b1 a2 b2 a3 b3 01
// Host: memory
#include "report.h"

static uint8_t stack_of_b[64];
static volatile uint16_t sp_of_other;
static volatile uint8_t served, in_stack_of_b;

ISR(TIMER0_OVF_vect) {
  ++served;
  if (SP > (uint16_t)stack_of_b && SP < (uint16_t)(stack_of_b + sizeof stack_of_b)) in_stack_of_b = 1;
}

// Saves call-saved registers on the current stack, and switches to the other routine's stack.
static __attribute__((naked, noinline)) void take_turns(void) {
  __asm__ volatile(
      "push r28\n\tpush r29\n\t"
      "in r24, __SP_L__\n\tin r25, __SP_H__\n\t"
      "lds r26, sp_of_other\n\tlds r27, sp_of_other+1\n\t"
      "sts sp_of_other, r24\n\tsts sp_of_other+1, r25\n\t"
      "in r0, __SREG__\n\tcli\n\tout __SP_H__, r27\n\tout __SREG__, r0\n\tout __SP_L__, r26\n\t"
      "pop r29\n\tpop r28\n\tret");
}

static __attribute__((noinline, used)) void run_b(void) {
  for (uint8_t i = 0xB1;; ++i) {
    report(i);
    take_turns();
    if (i == 0xB2)
      for (served = 0; !served;) {
      }
  }
}

int main(void) {
  uint8_t* top = stack_of_b + sizeof stack_of_b - 1;
  const uint16_t begin = (uint16_t)run_b;
  *top-- = (uint8_t)begin;
  *top-- = (uint8_t)(begin >> 8);
  *top-- = 0;
  *top-- = 0;
  sp_of_other = (uint16_t)top;
  TIMSK0 = _BV(TOIE0);
  TCCR0B = _BV(CS00);
  sei();
  for (uint8_t i = 0xA1; i != 0xA4; ++i) {
    report(i);
    take_turns();
  }
  report(in_stack_of_b);
  end_program();
}
