// A test fixture that runs sketches, built with the original Arduino core, on an AVR executor.
#pragma once

#include "sim/exec/avr/avr_executor.h"
#include "tests/support/sketch_test.h"

namespace robosim::exec {

class AvrTest : public SketchTest {
 protected:
  AvrTest() : SketchTest("avr", "uno") {}
  std::unique_ptr<Executor> make_executor(const BoardSpec& board,
                                          const std::filesystem::path& image) override {
    auto avr = std::make_unique<AvrExecutor>(board, image, make_detectors_);
    avr_ = avr.get();
    return avr;
  }

  MakeChipDetectors make_detectors_;  ///< creates the detectors that detect() turns on
  AvrExecutor* avr_ = nullptr;
};

}  // namespace robosim::exec
