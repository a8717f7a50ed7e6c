#pragma once
#include <Arduino.h>

class Sensors {
 public:
  virtual float position() = 0;   // -2 left ... 2 right
};

template <uint8_t N>
class SensorBar : public Sensors {
 public:
  SensorBar(const uint8_t (&pins)[N]) { memcpy(pins_, pins, N); }
  float position() override {
    float sum = 0, weight = 0;
    for (uint8_t i = 0; i < N; i++) {
      float v = analogRead(pins_[i]) / 1023.0f;
      if (v < 0.2f) continue;
      sum += v * (i - (N - 1) / 2.0f);
      weight += v;
    }
    if (weight > 0) last_ = sum / weight;
    return last_;
  }

 private:
  uint8_t pins_[N];
  float last_ = 0;
};

class Wheel {
 public:
  Wheel(uint8_t enable, uint8_t a, uint8_t b) : enable_(enable), a_(a), b_(b) {}
  void begin() {
    pinMode(enable_, OUTPUT);
    pinMode(a_, OUTPUT);
    pinMode(b_, OUTPUT);
  }
  void operator=(float speed) {   // -1 ... 1
    digitalWrite(a_, speed > 0);
    digitalWrite(b_, speed < 0);
    analogWrite(enable_, constrain(fabs(speed), 0.0f, 1.0f) * 255);
  }

 private:
  const uint8_t enable_, a_, b_;
};

class Strategy {
 public:
  virtual float turn(float position) = 0;
  virtual const char* name() const = 0;
  virtual ~Strategy() {}
};

class Proportional : public Strategy {
 public:
  explicit Proportional(float p) : p_(p) {}
  float turn(float x) override { return p_ * x; }
  const char* name() const override { return "proportional"; }

 protected:
  float p_;
};

class Derivative : public Proportional {
 public:
  Derivative(float p, float d) : Proportional(p), d_(d) {}
  float turn(float x) override {
    float t = p_ * x + d_ * (x - before_);
    before_ = x;
    return t;
  }
  const char* name() const override { return "with derivative"; }

 private:
  float d_, before_ = 0;
};

class Robot {
 public:
  Robot(Sensors& s, Wheel& l, Wheel& r) : sensors_(s), left_(l), right_(r) {}
  void begin() {
    left_.begin();
    right_.begin();
  }
  void use(Strategy* s) { strategy_ = s; }
  Strategy* strategy() const { return strategy_; }
  void step() {
    float t = strategy_->turn(sensors_.position());
    left_ = 0.3f + t;
    right_ = 0.3f - t;
  }

 private:
  Sensors& sensors_;
  Wheel &left_, &right_;
  Strategy* strategy_ = nullptr;
};
