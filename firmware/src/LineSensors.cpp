#include "LineSensors.h"

LineSensors::LineSensors(const uint8_t* pins, uint8_t count, uint16_t floor, uint16_t line) : count_(count) {
  for (uint8_t i = 0; i < count_; ++i) {
    pins_[i] = pins[i];
    floor_[i] = floor;
    line_[i] = line;
    raw_[i] = floor;
    value_[i] = 0;
  }
}

void LineSensors::begin() {
  for (uint8_t i = 0; i < count_; ++i) beginPin(pins_[i]);
  if (emitter_ != 255) {
    pinMode(emitter_, OUTPUT);
    digitalWrite(emitter_, HIGH);
  }
}

void LineSensors::setRange(uint16_t floor, uint16_t line) {
  for (uint8_t i = 0; i < count_; ++i) setRange(i, floor, line);
}

void LineSensors::setRange(uint8_t sensor, uint16_t floor, uint16_t line) {
  if (sensor >= count_) return;
  floor_[sensor] = floor;
  line_[sensor] = line;
}

void LineSensors::startCalibration(bool line_reads_high) {
  // Start with an inverted range, so that the first reading becomes both ends.
  setRange(line_reads_high ? 65535 : 0, line_reads_high ? 0 : 65535);
  line_reads_high_ = line_reads_high;
}

void LineSensors::calibrate() {
  readRaw(raw_);
  for (uint8_t i = 0; i < count_; ++i) {
    uint16_t& lowest = line_reads_high_ ? floor_[i] : line_[i];
    uint16_t& highest = line_reads_high_ ? line_[i] : floor_[i];
    if (raw_[i] < lowest) lowest = raw_[i];
    if (raw_[i] > highest) highest = raw_[i];
  }
}

uint16_t LineSensors::scaled(uint16_t raw, uint16_t floor, uint16_t line) {
  if (line == floor) return 0;
  const int32_t value = static_cast<int32_t>(kFullScale) * (static_cast<int32_t>(raw) - floor) /
                        (static_cast<int32_t>(line) - floor);
  if (value < 0) return 0;
  return value > kFullScale ? kFullScale : static_cast<uint16_t>(value);
}

int16_t LineSensors::weightedPosition(const uint16_t* values, uint8_t count, int16_t if_not_seen) {
  int32_t moment = 0;
  int32_t weight = 0;
  bool seen = false;
  for (uint8_t i = 0; i < count; ++i) {
    if (values[i] >= kSeen) seen = true;
    if (values[i] < kFaint) continue;
    const int16_t place = static_cast<int16_t>(1000 * i - 500 * (count - 1));
    moment += static_cast<int32_t>(values[i]) * place;
    weight += values[i];
  }
  return seen ? static_cast<int16_t>(moment / weight) : if_not_seen;
}

void LineSensors::read() {
  readRaw(raw_);
  seen_ = false;
  for (uint8_t i = 0; i < count_; ++i) {
    value_[i] = scaled(raw_[i], floor_[i], line_[i]);
    if (value_[i] >= kSeen) seen_ = true;
  }
  const int16_t end = static_cast<int16_t>(500 * (count_ - 1));
  int16_t if_not_seen = 0;  // a gap
  if (position_ > end - 1000) if_not_seen = end;
  if (position_ < 1000 - end) if_not_seen = -end;
  position_ = weightedPosition(value_, count_, if_not_seen);
}

void AnalogLineSensors::beginPin(uint8_t pin) { pinMode(pin, INPUT); }

void AnalogLineSensors::readRaw(uint16_t* raw) {
  for (uint8_t i = 0; i < count_; ++i) raw[i] = static_cast<uint16_t>(analogRead(pins_[i]));
}

void DigitalLineSensors::beginPin(uint8_t pin) { pinMode(pin, INPUT); }

void DigitalLineSensors::readRaw(uint16_t* raw) {
  for (uint8_t i = 0; i < count_; ++i) raw[i] = digitalRead(pins_[i]) == HIGH ? 1 : 0;
}

void RcLineSensors::beginPin(uint8_t pin) { pinMode(pin, INPUT); }

void RcLineSensors::readRaw(uint16_t* raw) {
  for (uint8_t i = 0; i < count_; ++i) {
    raw[i] = timeout_us_;
    pinMode(pins_[i], OUTPUT);
    digitalWrite(pins_[i], HIGH);
  }
  delayMicroseconds(10);
  // The capacitors drain from here on. In input mode, writing LOW switches the pull-ups off.
  const uint32_t start = micros();
  for (uint8_t i = 0; i < count_; ++i) {
    pinMode(pins_[i], INPUT);
    digitalWrite(pins_[i], LOW);
  }
  uint8_t draining = count_;
  while (draining > 0) {
    const uint32_t elapsed = micros() - start;
    if (elapsed >= timeout_us_) return;
    for (uint8_t i = 0; i < count_; ++i) {
      if (raw[i] == timeout_us_ && digitalRead(pins_[i]) == LOW) {
        raw[i] = static_cast<uint16_t>(elapsed);
        --draining;
      }
    }
  }
}
