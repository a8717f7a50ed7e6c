// Runs a sketch on an AVR that all detectors observe.
#pragma once

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

  bool watched_ = true;
  std::vector<Pin> counted_;  ///< pins on which every edge matters
};

}  // namespace robosim::detect
