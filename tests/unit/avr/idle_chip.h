// A chip for tests of peripherals. Its processor waits in an endless loop, also at each interrupt vector. The
// test writes the chip's registers as firmware would.
#pragma once

#include <vector>

#include "hal/board/atmega328p.h"
#include "hal/board/avr_registers.h"
#include "tests/conformance/bench.h"

namespace robosim::avr {

class IdleChip {
 public:
  explicit IdleChip(const ChipSpec& spec = kAtmega328p) : bench(spec, loops(spec)) {}
  void write(Address address, std::uint8_t value) { bench.chip.cpu().store(address, value); }
  std::uint8_t read(Address address) { return bench.chip.cpu().load(address); }
  void run(Cycle cycles) { bench.run(cycles); }
  /// Runs until `cycle`, or one cycle longer, because each pass of the endless loop takes two cycles.
  void run_to(Cycle cycle) { bench.chip.run_to(cycle); }
  Cycle now() { return bench.chip.cycle(); }
  int pin(char port, int bit) { return bench.chip.pins().at(port, bit); }
  void let_interrupts() { bench.chip.cpu().set_sreg(Cpu::kI); }
  /// Executes SLEEP. After waking, the processor waits in a loop again.
  void fall_asleep() {
    bench.chip.cpu().set_pc(kSleep);
    run(1);
  }
  /// Returns the number of the last interrupt's vector; 0 = no interrupt since the reset. After
  /// fall_asleep(), the result is valid only once an interrupt has occurred.
  int vector() { return static_cast<int>(bench.chip.cpu().pc() / 2); }

 private:
  static constexpr std::uint32_t kSleep = 0x1000;  // in words

  static std::vector<std::uint8_t> loops(const ChipSpec& spec) {
    std::vector<std::uint8_t> flash(spec.flash_bytes);
    for (std::size_t i = 0; i < flash.size(); i += 2) {
      flash[i] = 0xFF;  // rjmp .-2
      flash[i + 1] = 0xCF;
    }
    flash[2 * kSleep] = 0x88;
    flash[2 * kSleep + 1] = 0x95;
    return flash;
  }

 public:
  conformance::Bench bench;
};

}  // namespace robosim::avr
