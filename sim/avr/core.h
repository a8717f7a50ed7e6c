// The parts that the peripherals of one chip share: the processor with its registers, the event queue, the
// interrupts, and the surroundings. A peripheral holds a reference to it, and hooks its registers in its
// constructor:
//
//   Eeprom::Eeprom(Core& core) : core_(core) {
//     core.cpu.on_write<&Eeprom::write_control>(reg::kEecr, this);
//     done_ = core.events.add<&Eeprom::done>(this);
//     core.keep(state_);
//   }
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "sim/avr/adc_triggers.h"
#include "sim/avr/chip_environment.h"
#include "sim/avr/cpu.h"
#include "sim/avr/events.h"
#include "sim/avr/interrupts.h"
#include "sim/avr/mark_visitor.h"
#include "sim/base/snapshot_registry.h"

namespace robosim::avr {

/// A part of the chip with its own registers.
class Peripheral {
 public:
  virtual ~Peripheral() = default;
  /// Resets it as after power-on. Its registers hold their initial values (the processor has set all of them
  /// to 0), its events are cancelled and its requests withdrawn already.
  virtual void reset(Cycle at) = 0;
  /// Stops or starts its clock at `at`: by a sleep mode, or its bit in PRR.
  virtual void clock_runs(bool runs, Cycle at) {
    (void)runs;
    (void)at;
  }
  /// Handles that the processor falls asleep, in a mode with or without the ADC's clock. Its own clock may
  /// stop next. Called for peripherals with that clock.
  virtual void falls_asleep(bool adc_clock_runs, Cycle at) {
    (void)adc_clock_runs;
    (void)at;
  }
  /// Returns the enabled interrupts that may come without accesses to its registers; one bit per vector.
  virtual std::uint64_t may_interrupt() const { return 0; }
};

struct Core {
  Core(const ChipSpec& spec, std::span<const std::uint8_t> flash, Address last_ram, ChipEnvironment& around,
       std::int64_t oscillator)
      : chip(spec),
        cpu(spec, flash, last_ram),
        environment(around),
        oscillator_hz(oscillator),
        clock_hz(oscillator) {
    cpu.waiting = &interrupts.state;
    keep(cpu.state);
    snapshots.add_memory(cpu.data);
    keep(events.state);
    keep(interrupts.state);
    keep(triggers.state);
    keep(clock_hz);
    keep(reset_may_come);
  }

  Cycle now() const { return cpu.cycle(); }
  std::uint8_t& at(Address address) { return cpu.data[address]; }

  /// Schedules an event at `cycle`, possibly before the end of the processor's present run.
  void schedule(Events::Id id, Cycle cycle) {
    events.schedule(id, cycle);
    cpu.look_up();
  }
  /// When the clock of an event stopped, and when the event was due.
  struct Held {
    Cycle since = 0, due = kNoCycle;
  };
  /// Suspends an event while its peripheral's clock is stopped, and delays it by that time.
  void hold(Events::Id id, Held& held, Cycle at) {
    held = {at, events.due(id)};
    events.cancel(id);
  }
  void go_on(Events::Id id, const Held& held, Cycle at) {
    if (held.due != kNoCycle) schedule(id, held.due + (at - held.since));
  }
  /// Suspends or resumes an event, as the clock stops or runs on.
  void hold_or_go_on(Events::Id id, Held& held, bool runs, Cycle at) {
    if (runs) {
      go_on(id, held, at);
    } else {
      hold(id, held, at);
    }
  }
  void request(int vector, bool requested) {
    interrupts.request(vector, requested);
    if (requested) cpu.look_up();
  }

  /// Reports that `vector` was requested again before its handler ran, so that one event is lost.
  void lose(int vector) const {
    if (on_lost) on_lost(on_lost_self, vector);
  }

  /// Returns the number of the processor's cycles in a duration, rounded up.
  Cycle cycles(std::int64_t nanoseconds) const {
    constexpr std::int64_t kSecond = 1'000'000'000;
    return static_cast<Cycle>((nanoseconds * clock_hz + kSecond - 1) / kSecond);
  }
  /// Divides the oscillator's clock by `divisor` for the processor from now on.
  void divide_clock(int divisor) {
    const std::int64_t before = clock_hz;
    clock_hz = oscillator_hz / divisor;
    if (clock_hz == before) return;
    for (const ClockChange& change : clock_changes_) change.call(change.self, before);
  }
  /// Calls void Owner::Method(std::int64_t hz_before) when the processor's clock has changed: a fixed
  /// duration then takes another number of cycles.
  template <auto Method, typename Owner>
  void on_clock_change(Owner* owner) {
    clock_changes_.push_back(
        {[](void* self, std::int64_t before) { (static_cast<Owner*>(self)->*Method)(before); }, owner});
  }
  /// Converts `at` from cycles of a clock of `hz_before` to cycles of the present clock.
  Cycle rescaled(Cycle at, std::int64_t hz_before) const {
    if (at == kNoCycle || at <= now()) return at;
    const auto before = static_cast<Cycle>(hz_before);
    return now() + ((at - now()) * static_cast<Cycle>(clock_hz) + before - 1) / before;
  }

  /// Registers `state` as changing state: snapshots copy it byte by byte.
  template <typename State>
  void keep(State& state) {
    static_assert(std::is_trivially_copyable_v<State>);
    snapshots.add(state);
  }

  const ChipSpec& chip;
  Cpu cpu;
  Events events;
  Interrupts interrupts;
  AdcTriggers triggers;
  ChipEnvironment& environment;
  const std::int64_t oscillator_hz;
  std::int64_t clock_hz;      ///< of the processor: the oscillator's frequency, divided by CLKPR
  double supply_volts = 5.0;  ///< also of AVCC. The chip's user may set them.
  SnapshotRegistry snapshots;
  MarkVisitor* visitor = nullptr;  ///< for marks; null = they stop the chip
  /// A reset is possible with interrupts off: the watchdog's.
  bool reset_may_come = false;
  /// Resets the chip after the running instruction; `flags` are MCUSR's. Set by the chip.
  void (*reset)(void* self, std::uint8_t flags) = nullptr;
  void* reset_self = nullptr;
  /// Called when an event is lost; may be null.
  void (*on_lost)(void* self, int vector) = nullptr;
  void* on_lost_self = nullptr;

 private:
  struct ClockChange {
    void (*call)(void* self, std::int64_t hz_before) = nullptr;
    void* self = nullptr;
  };
  std::vector<ClockChange> clock_changes_;
};

}  // namespace robosim::avr
