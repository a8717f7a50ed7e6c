#include "ClockedReceiver.h"

ClockedReceiver* ClockedReceiver::receiver_ = 0;

void ClockedReceiver::begin() {
  receiver_ = this;
  pinMode(data_, INPUT);
  pinMode(clock_, INPUT);
  pinMode(enable_, INPUT);
  attachInterrupt(digitalPinToInterrupt(clock_), onClock, RISING);
  attachInterrupt(digitalPinToInterrupt(enable_), onEnable, CHANGE);
}

bool ClockedReceiver::available() {
  noInterrupts();
  const bool come = has_come_;
  has_come_ = false;
  if (come) {
    bits_ = come_bits_;
    value_ = come_;
  }
  interrupts();
  return come;
}

void ClockedReceiver::onClock() {
  ClockedReceiver& r = *receiver_;
  r.coming_ = static_cast<uint16_t>(r.coming_ << 1 | (digitalRead(r.data_) == HIGH ? 1 : 0));
  if (r.coming_bits_ < 255) r.coming_bits_ = r.coming_bits_ + 1;
}

void ClockedReceiver::onEnable() {
  ClockedReceiver& r = *receiver_;
  if (digitalRead(r.enable_) == HIGH) {
    r.coming_ = 0;
    r.coming_bits_ = 0;
    return;
  }
  r.come_ = r.coming_;
  r.come_bits_ = r.coming_bits_;
  r.has_come_ = true;
}
