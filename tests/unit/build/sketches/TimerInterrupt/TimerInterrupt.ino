// Runs a control loop on Timer1, at 1 kHz.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/atomic.h>

volatile unsigned long ticks = 0;
volatile boolean due;

ISR(TIMER1_COMPA_vect) {
  ticks++;
  due = true;
}

EMPTY_INTERRUPT(TIMER1_COMPB_vect)

ISR(ADC_vect, ISR_NOBLOCK) { ticks += ADCH; }

void setup() {
  Serial.begin(9600);
  noInterrupts();
  TCCR1A = 0;
  TCCR1B = 0;
  TCNT1 = 0;
  OCR1A = 15999;
  TCCR1B |= (1 << WGM12) | (1 << CS10);
  TIMSK1 |= (1 << OCIE1A);
  interrupts();
}

void loop() {
  while (!due)
    ;
  unsigned long now;
  ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
    now = ticks;
    due = false;
  }
  uint8_t saved = SREG;
  cli();
  now += 0;
  SREG = saved;
  if (now % 1000 == 0) Serial.println(now);
}
