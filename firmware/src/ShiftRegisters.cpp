#include "ShiftRegisters.h"

void ShiftRegisters::begin() {
  pinMode(data_, OUTPUT);
  pinMode(clock_, OUTPUT);
  pinMode(latch_, OUTPUT);
  digitalWrite(latch_, LOW);
  show();
}

void ShiftRegisters::show() {
  for (uint8_t i = count_; i-- > 0;) shiftOut(data_, clock_, MSBFIRST, bits_[i]);
  digitalWrite(latch_, HIGH);
  digitalWrite(latch_, LOW);
}
