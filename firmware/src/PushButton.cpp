#include "PushButton.h"

void PushButton::begin() {
  pinMode(pin_, pressed_is_ == PressedIs::low ? INPUT_PULLUP : INPUT);
  pressed_ = candidate_ = look();
  changed_ = false;
  candidate_since_ = changed_at_ = millis();
}

void PushButton::update() {
  const uint32_t now = millis();
  const bool level = look();
  changed_ = false;
  if (level != candidate_) {
    candidate_ = level;
    candidate_since_ = now;
  }
  if (candidate_ != pressed_ && now - candidate_since_ >= debounce_ms_) {
    pressed_ = candidate_;
    changed_ = true;
    changed_at_ = now;
  }
}
