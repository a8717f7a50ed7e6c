// Runs random instructions on Robosim's AVR processor and on the model in manual_model.h, from the same
// random state.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sim/mcu/avr/cpu.h"
#include "tests/unit/avr_cpu/manual_model.h"

namespace robosim::avr {

/// The state at the start of a program. All other memory keeps the content from the previous program.
struct Start {
  std::array<std::uint8_t, 32> registers{};
  std::uint8_t sreg = 0, rampz = 0, eind = 0;
  std::uint16_t sp = 0;
  std::uint32_t pc = 0;
};

/// Fills a flash with random instructions that the manual defines, and returns its content. The targets of
/// JMP and CALL are in flash.
std::vector<std::uint16_t> random_flash(std::mt19937& random, bool long_pc);

/// The processor, and the model with which it is compared. The data memory of each has 64 KB: I/O registers
/// without peripherals, followed by RAM.
class Pair {
 public:
  /// If `long_pc` is true, the program counter has 22 bits and the flash has 256 KB. Otherwise, they have 16
  /// bits and 128 KB.
  Pair(std::mt19937& random, bool long_pc);

  Start random_start(std::mt19937& random) const;
  void begin(const Start& start);
  /// Runs the model for at most `instructions`, and then runs the processor to the same cycle. Returns false
  /// if the program cannot continue, because the next instruction is reserved, undefined, or outside of
  /// flash.
  bool run(int instructions);
  /// Describes the differences between processor and model, or returns "".
  std::string difference() const;

  ManualModel manual;
  Cpu cpu;

 private:
  /// Returns whether the manual leaves the result of the next instruction undefined. This includes a stack
  /// that overwrites SP, and an incremented or decremented pointer that points to X, Y or Z.
  bool is_undefined() const;

  bool long_pc_;
  std::string wrong_stop_;
};

}  // namespace robosim::avr
