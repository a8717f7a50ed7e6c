// A test fixture that runs a sketch on an emulated AVR. All detectors of target avr observe the sketch.
#pragma once

#include <string>
#include <vector>

#include "sim/detect/avr/chip_detectors.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::detect {

using exec::Detected;
using exec::SourceLine;

class AvrDetectorTest : public exec::AvrTest {
 protected:
  AvrDetectorTest() { make_detectors_ = avr::chip_detectors; }
  void before_power_on() override {
    if (watched_) avr_->detect(counted_);
  }

  /// Returns the findings for a sketch that runs for `duration`.
  std::vector<Detected> found_in(const std::string& sketch, SimTime duration) {
    start(sketch);
    run(duration);
    return avr_->detected();
  }

  bool watched_ = true;
  std::vector<Pin> counted_;  ///< pins on which every edge matters, such as those of an encoder
};

}  // namespace robosim::detect
