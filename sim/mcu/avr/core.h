// Holds the parts that all peripherals of a chip share: processor, event queue, interrupts and environment. A
// peripheral stores a reference to the core. The peripheral's constructor registers hooks and events:
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

#include "sim/base/snapshot_registry.h"
#include "sim/mcu/avr/adc_triggers.h"
#include "sim/mcu/avr/chip_environment.h"
#include "sim/mcu/avr/cpu.h"
#include "sim/mcu/avr/events.h"
#include "sim/mcu/avr/interrupts.h"
#include "sim/mcu/avr/mark_visitor.h"

namespace robosim::avr {

/// A part of the chip with its own registers.
class Peripheral {
 public:
  virtual ~Peripheral() = default;
  /// Resets the peripheral to its state after power-on. Before this call, the processor has set all registers
  /// to 0. All events are cancelled, and all interrupt requests are withdrawn.
  virtual void reset(Cycle at) = 0;
  /// Stops or starts the peripheral's clock at `at`, because of a sleep mode or the peripheral's bit in PRR.
  virtual void clock_runs(bool runs, Cycle at) {
    (void)runs;
    (void)at;
  }
  /// Called when the chip enters a sleep mode. `adc_clock_runs` is set if the ADC's clock runs in this mode.
  /// Only peripherals on the ADC's clock get this call. If the mode stops their clock, clock_runs() follows.
  virtual void falls_asleep(bool adc_clock_runs, Cycle at) {
    (void)adc_clock_runs;
    (void)at;
  }
  /// Returns the enabled interrupts that can occur without accesses to the peripheral's registers; one bit
  /// per vector.
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

  /// Schedules an event at `cycle`. Ends the processor's current run early, because the run may last beyond
  /// `cycle`.
  void schedule(Events::Id id, Cycle cycle) {
    events.schedule(id, cycle);
    cpu.look_up();
  }
  /// The cycle at which an event's clock stopped, and the cycle at which the event was due.
  struct Held {
    Cycle since = 0, due = kNoCycle;
  };
  /// Suspends an event when its peripheral's clock stops. go_on() schedules the event again, delayed by the
  /// duration of the stop.
  void hold(Events::Id id, Held& held, Cycle at) {
    held = {at, events.due(id)};
    events.cancel(id);
  }
  void go_on(Events::Id id, const Held& held, Cycle at) {
    if (held.due != kNoCycle) schedule(id, held.due + (at - held.since));
  }
  /// Suspends or resumes an event when its peripheral's clock stops or starts.
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

  /// Reports that `vector` was requested again before its handler ran, so that one request is lost.
  void lose(int vector) const {
    if (on_lost) on_lost(on_lost_self, vector);
  }

  /// Returns the number of processor cycles in a duration, rounded up.
  Cycle cycles(std::int64_t nanoseconds) const {
    constexpr std::int64_t kSecond = 1'000'000'000;
    return static_cast<Cycle>((nanoseconds * clock_hz + kSecond - 1) / kSecond);
  }
  /// Sets the processor's clock to the oscillator's clock divided by `divisor`.
  void divide_clock(int divisor) {
    const std::int64_t before = clock_hz;
    clock_hz = oscillator_hz / divisor;
    if (clock_hz == before) return;
    for (const ClockChange& change : clock_changes_) change.call(change.self, before);
  }
  /// Registers void Owner::Method(std::int64_t hz_before), which is called after the processor's clock has
  /// changed. A fixed duration then takes a different number of cycles.
  template <auto Method, typename Owner>
  void on_clock_change(Owner* owner) {
    clock_changes_.push_back(
        {[](void* self, std::int64_t before) { (static_cast<Owner*>(self)->*Method)(before); }, owner});
  }
  /// Returns the new cycle of an event due at `at`, after the clock has changed from `hz_before`. The
  /// remaining time in seconds stays the same.
  Cycle rescaled(Cycle at, std::int64_t hz_before) const {
    if (at == kNoCycle || at <= now()) return at;
    const auto before = static_cast<Cycle>(hz_before);
    return now() + ((at - now()) * static_cast<Cycle>(clock_hz) + before - 1) / before;
  }

  /// Adds `state` to the state that snapshots copy byte by byte.
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
  std::int64_t clock_hz;  ///< processor clock: the oscillator's frequency divided by CLKPR's divisor
  SnapshotRegistry snapshots;
  MarkVisitor* visitor = nullptr;  ///< called at marks (mark_visitor.h); null = marks stop the chip
  /// Set while the watchdog can reset the chip even with interrupts off.
  bool reset_may_come = false;
  /// Resets the chip after the current instruction, and adds `flags` to MCUSR. The chip sets this callback.
  void (*reset)(void* self, std::uint8_t flags) = nullptr;
  void* reset_self = nullptr;
  /// Called when the ADC has sampled a pin; may be null. Not called if neither this source nor the source of
  /// the previous sample has a resistance. `error` is the capacitor's voltage minus the source's voltage.
  void (*on_conversion)(void* self, int pin, double error) = nullptr;
  void* on_conversion_self = nullptr;
  /// Called when an interrupt request is lost; may be null.
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
