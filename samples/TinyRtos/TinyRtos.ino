// A preemptive kernel in seventy lines: three tasks with separate stacks, switched by timer 2 every 2 ms.
#include "kernel.h"

volatile int16_t error = 0;
volatile uint16_t samples = 0;

void sense() {
  int8_t last = 0;
  for (;;) {
    bool l = digitalRead(A0), m = digitalRead(A1), r = digitalRead(A2);
    if (l || m || r) last = l && !r ? -1 : r && !l ? 1 : m ? 0 : last;
    error = last;
    samples++;
  }
}

void steer() {
  for (;;) {
    int16_t e = error;
    digitalWrite(7, e >= 0);
    digitalWrite(8, e < 0);
    digitalWrite(9, e <= 0);
    digitalWrite(10, e > 0);
    analogWrite(5, e < 0 ? 70 : 115);
    analogWrite(6, e > 0 ? 70 : 115);
  }
}

void report() {
  for (;;) {
    waitTicks(250);
    cli();
    uint16_t n = samples;
    samples = 0;
    sei();
    Serial.print(F("samples in 500 ms: "));
    Serial.println(n);
  }
}

uint8_t stackSense[96], stackSteer[96], stackReport[128];

void setup() {
  Serial.begin(115200);
  for (uint8_t p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  addTask(sense, stackSense, sizeof stackSense);
  addTask(steer, stackSteer, sizeof stackSteer);
  addTask(report, stackReport, sizeof stackReport);
  startKernel();
}

void loop() {
  // the idle task
}
