#include "Pony.h"

namespace {

const uint8_t SENSOR_PINS[] = {A0, A1, A2};  // left, middle, right; HIGH on the line
const uint8_t BUMPER_PIN = 7;                // LOW when pressed

// Bits of register 0: buzzer, motors (left forward, left backward, right forward, right backward), LEDs.
const uint8_t BUZZER = 0x80;
const uint8_t LEFT_FORWARD = 0x40, LEFT_BACKWARD = 0x20, RIGHT_FORWARD = 0x10, RIGHT_BACKWARD = 0x08;
const uint8_t MOTORS = 0x78;
const uint8_t LIGHTS = 0x07;

// Values of registers 1 (ones) and 2 (tens). A low bit lights a segment: e g f a b c d.
const uint8_t DIGITS[] = {0x02, 0x4F, 0x24, 0x05, 0x49, 0x11, 0x10, 0x47, 0x00, 0x41};
const uint8_t DARK = 0x7F, DASH = 0x7D;

}  // namespace

void Pony::begin() {
  for (uint8_t i = 0; i < 3; ++i) pinMode(SENSOR_PINS[i], INPUT);
  pinMode(BUMPER_PIN, INPUT_PULLUP);
  out_.set(1, DARK);
  out_.set(2, DARK);
  out_.begin();
  next_us_ = micros();
}

void Pony::drive(uint8_t code) {
  uint8_t bits = static_cast<uint8_t>((out_.get(0) & LIGHTS) | code);
  if (beep_steps_ > 0) bits |= BUZZER;
  if (bits == out_.get(0)) return;
  out_.set(0, bits);
  out_.show();
}

void Pony::pause() {
  beep_steps_ = 0;
  drive(0);
  for (uint16_t ms = 0; digitalRead(BUMPER_PIN) == LOW; ++ms) {
    if (ms == kPatienceMs) {
      blocked_ = true;
      return;
    }
    delay(1);
  }
}

void Pony::step(int8_t left, int8_t right) {
  if (!blocked_ && digitalRead(BUMPER_PIN) == LOW) pause();
  uint8_t code = 0;
  if (phase_ < (left < 0 ? -left : left)) code |= left < 0 ? LEFT_BACKWARD : LEFT_FORWARD;
  if (phase_ < (right < 0 ? -right : right)) code |= right < 0 ? RIGHT_BACKWARD : RIGHT_FORWARD;
  drive(code);
  phase_ = phase_ + kStepMs < kPeriod ? phase_ + kStepMs : 0;
  if (beep_steps_ > 0) --beep_steps_;
  ++steps_;

  next_us_ += 1000UL * kStepMs;
  const uint32_t wait = next_us_ - micros();
  if (wait <= 1000UL * kStepMs) {
    delayMicroseconds(static_cast<uint16_t>(wait));
  } else {
    next_us_ = micros();  // the caller took longer than a step
  }
  const uint8_t seen = look();
  seen_ = static_cast<uint8_t>((seen & seen_before_) | (seen_ & (seen | seen_before_)));
  seen_before_ = seen;
}

void Pony::rest(uint16_t ms) {
  for (uint16_t i = 0; i < ms / kStepMs; ++i) step(0, 0);
}

uint8_t Pony::look() const {
  uint8_t seen = 0;
  for (uint8_t i = 0; i < 3; ++i)
    if (digitalRead(SENSOR_PINS[i]) == HIGH) seen = static_cast<uint8_t>(seen | 1 << i);
  return seen;
}

void Pony::light(uint8_t lights) {
  out_.set(0, static_cast<uint8_t>((out_.get(0) & ~LIGHTS) | (lights & LIGHTS)));
  out_.show();
}

void Pony::show(uint8_t number) {
  const bool fits = number < 100;
  out_.set(1, fits ? DIGITS[number % 10] : DASH);
  out_.set(2, !fits ? DASH : number < 10 ? DARK : DIGITS[number / 10]);
  out_.show();
}

void Pony::beep(uint16_t ms) { beep_steps_ = ms / kStepMs; }
