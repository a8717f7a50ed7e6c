// Runs random instructions on the processor and on the manual's model, from the same random state.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sim/mcu/avr/cpu.h"
#include "tests/unit/avr_cpu/manual_model.h"

namespace robosim::avr {

/// The state at the start of a program. Other memory keeps its content from the previous program.
struct Start {
  std::array<std::uint8_t, 32> registers{};
  std::uint8_t sreg = 0, rampz = 0, eind = 0;
  std::uint16_t sp = 0;
  std::uint32_t pc = 0;
};

/// Returns flash full of random instructions that the manual defines, with targets in flash.
std::vector<std::uint16_t> random_flash(std::mt19937& random, bool long_pc);

/// The processor and the model. Data memory has 64 KB: I/O registers without peripherals, and then RAM.
class Pair {
 public:
  /// With `long_pc`, uses 22 bits and the largest ATmega's flash, otherwise 16 bits and 128 KB.
  Pair(std::mt19937& random, bool long_pc);

  Start random_start(std::mt19937& random) const;
  void begin(const Start& start);
  /// Runs the model for at most `instructions`, then the processor to the same cycle. Returns false if the
  /// program cannot continue: the next instruction is reserved, undefined, or outside of flash.
  bool run(int instructions);
  /// Describes the first difference, or returns "".
  std::string difference() const;

  ManualModel manual;
  Cpu cpu;

 private:
  /// Returns whether the manual leaves the result undefined, including a stack that overwrites SP.
  bool is_undefined() const;

  bool long_pc_;
  std::string wrong_stop_;
};

}  // namespace robosim::avr
