// Test suites that run each sketch on several targets. Each expected result is stated once, for all targets.
#pragma once

#include "tests/support/sketch_test.h"
#include "tests/unit/targets/target.h"

namespace robosim::exec {

class TargetTest : public SketchTest, public testing::WithParamInterface<Target> {
 protected:
  TargetTest() : SketchTest(GetParam().name, GetParam().board) {}
  std::unique_ptr<Executor> make_executor(const BoardSpec& board,
                                          const std::filesystem::path& image) override {
    return GetParam().make_executor(board, image);
  }
  /// Returns the supply voltage, which is also the default reference of the ADC.
  double supply() { return board().spec().supply_volts; }
  PinDrive drive(const char* name) { return board().drive(pin(name)); }
  /// Runs a sketch that executes `statements` in setup(), and then does nothing.
  void after(const std::string& statements) {
    output("void setup() { " + statements + " }\nvoid loop() {}", 50 * kMillisecond);
  }
};

class OnEveryTarget : public TargetTest {};  ///< host, avr and stm32
class OnEveryChip : public TargetTest {};    ///< avr and stm32
class OnAtmega : public TargetTest {};       ///< host and avr, which have the registers of an ATmega328P

}  // namespace robosim::exec
