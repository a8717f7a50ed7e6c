// Runs random instructions on the processor and on the manual's model, from the same random state.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sim/avr/cpu.h"
#include "tests/unit/avr_cpu/manual_model.h"

namespace robosim::avr {

/// Where a program begins: the other memory is kept from the one before.
struct Start {
  std::array<std::uint8_t, 32> registers{};
  std::uint8_t sreg = 0, rampz = 0, eind = 0;
  std::uint16_t sp = 0;
  std::uint32_t pc = 0;
};

/// Returns flash full of random instructions that the manual defines, with targets in flash.
std::vector<std::uint16_t> random_flash(std::mt19937& random, bool long_pc);

/// The two of them. Data memory is 64 KB of RAM behind the registers of I/O, which keep what is written.
class Pair {
 public:
  /// `long_pc`: of 22 bits, on the largest ATmega's flash; else on 128 KB, which 16 bits reach.
  Pair(std::mt19937& random, bool long_pc);

  Start random_start(std::mt19937& random) const;
  void begin(const Start& start);
  /// Runs at most `instructions`, the model first. Returns false if the program cannot continue: the next
  /// instruction is reserved, undefined, or outside of flash.
  bool run(int instructions);
  /// Describes the first difference; "" = none.
  std::string difference() const;

  ManualModel manual;
  Cpu cpu;

 private:
  /// Returns whether the manual leaves the result open. A stack that overwrites SP counts as undefined.
  bool is_undefined() const;

  bool long_pc_;
  std::string wrong_stop_;
};

}  // namespace robosim::avr
