// What the peripherals of one chip share: the processor with its registers, the queue, the interrupts, and the
// surroundings. A peripheral holds a reference to it, and hooks its registers in its constructor:
//
//   Eeprom::Eeprom(Core& core) : core_(core) {
//     core.cpu.on_write<&Eeprom::write_control>(reg::kEecr, this);
//     done_ = core.events.add<&Eeprom::done>(this);
//     core.keep(state_);
//   }
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "sim/avr/cpu.h"
#include "sim/avr/events.h"
#include "sim/avr/interrupts.h"
#include "sim/avr/surroundings.h"

namespace robosim::avr {

/// A part of the chip with registers of its own.
class Peripheral {
 public:
  virtual ~Peripheral() = default;
  /// As after power-on: its registers hold their initial values (the processor has put 0 into all of them), its
  /// events are cancelled and its requests taken back already.
  virtual void reset(Cycle at) = 0;
  /// Its clock stands still from `at` on, or runs on: a sleep mode, or its bit in PRR.
  virtual void clock_runs(bool runs, Cycle at) {
    (void)runs;
    (void)at;
  }
  /// The processor falls asleep: in the ADC's noise reduction mode, or another. Its clock may stop next.
  virtual void falls_asleep(bool noise_reduction, Cycle at) {
    (void)noise_reduction;
    (void)at;
  }
};

struct Core {
  Core(const ChipSpec& spec, std::span<const std::uint8_t> flash, Address last_ram, Surroundings& around)
      : chip(spec), cpu(spec, flash, last_ram), outside(around) {
    keep(cpu.state);
    keep(events.state);
    keep(interrupts.state);
  }

  Cycle now() const { return cpu.cycle(); }
  std::uint8_t& at(Address address) { return cpu.data[address]; }

  /// An event at `cycle`, which may be sooner than the processor was told to run to.
  void schedule(Events::Id id, Cycle cycle) {
    events.schedule(id, cycle);
    cpu.look_up();
  }
  void request(int vector, bool requested) {
    interrupts.request(vector, requested);
    if (requested) cpu.look_up();
  }

  /// `state` is a part of what changes while the chip runs: snapshots copy it byte by byte.
  template <typename State>
  void keep(State& state) {
    static_assert(std::is_trivially_copyable_v<State>);
    kept.push_back({reinterpret_cast<std::byte*>(&state), sizeof state});
  }

  const ChipSpec& chip;
  Cpu cpu;
  Events events;
  Interrupts interrupts;
  Surroundings& outside;
  struct Kept {
    std::byte* bytes = nullptr;
    std::size_t size = 0;
  };
  std::vector<Kept> kept;
  /// A reset may come though interrupts are off: the watchdog's.
  bool reset_may_come = false;
  /// The chip resets itself; `flags` are MCUSR's. Set by the chip.
  void (*reset)(void* self, std::uint8_t flags) = nullptr;
  void* reset_self = nullptr;
};

}  // namespace robosim::avr
