#include "kernel.h"

#define TASKS 4   // number 0 is setup() and loop()

static volatile uint16_t savedSp[TASKS];
static volatile uint8_t current = 0, count = 1;
static volatile uint16_t now = 0;

#define SAVE                                                                                     \
  asm volatile(                                                                                  \
      "push r0\n in r0, __SREG__\n push r0\n push r1\n clr r1\n push r2\n push r3\n push r4\n"   \
      "push r5\n push r6\n push r7\n push r8\n push r9\n push r10\n push r11\n push r12\n"       \
      "push r13\n push r14\n push r15\n push r16\n push r17\n push r18\n push r19\n push r20\n"  \
      "push r21\n push r22\n push r23\n push r24\n push r25\n push r26\n push r27\n push r28\n"  \
      "push r29\n push r30\n push r31\n")
#define RESTORE                                                                                  \
  asm volatile(                                                                                  \
      "pop r31\n pop r30\n pop r29\n pop r28\n pop r27\n pop r26\n pop r25\n pop r24\n pop r23\n" \
      "pop r22\n pop r21\n pop r20\n pop r19\n pop r18\n pop r17\n pop r16\n pop r15\n pop r14\n" \
      "pop r13\n pop r12\n pop r11\n pop r10\n pop r9\n pop r8\n pop r7\n pop r6\n pop r5\n"      \
      "pop r4\n pop r3\n pop r2\n pop r1\n pop r0\n out __SREG__, r0\n pop r0\n")

// Switches tasks. Calls no function, because the return address would stay on the old stack.
ISR(TIMER2_COMPA_vect, ISR_NAKED) {
  SAVE;
  savedSp[current] = SP;
  now++;
  current = (uint8_t)(current + 1) < count ? current + 1 : 0;
  SP = savedSp[current];
  RESTORE;
  asm volatile("reti");
}

void addTask(void (*task)(), uint8_t* stack, uint16_t size) {
  uint8_t* top = stack + size - 1;
  uint16_t entry = (uint16_t)task;
  *top-- = entry & 0xFF;
  *top-- = entry >> 8;
  *top-- = 0;                                   // r0
  *top-- = 0x80;                                // SREG: interrupts on
  for (uint8_t i = 1; i < 32; i++) *top-- = 0;  // r1 to r31
  savedSp[count++] = (uint16_t)top;
}

void startKernel() {
  cli();
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS22) | _BV(CS20);   // 16 MHz / 128
  OCR2A = 249;                      // 2 ms
  TIMSK2 = _BV(OCIE2A);
  sei();
}

void waitTicks(uint16_t ticks) {
  cli();
  uint16_t from = now;
  sei();
  for (;;) {
    cli();
    uint16_t passed = now - from;
    sei();
    if (passed >= ticks) return;
  }
}
