#pragma once

class Filter {
 public:
  explicit Filter(float weight) : weight_(weight) {}
  float next(float value);

 private:
  float weight_;
  float state_ = 0;
};
