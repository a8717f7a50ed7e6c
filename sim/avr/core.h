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

#include "sim/avr/cpu.h"
#include "sim/avr/events.h"
#include "sim/avr/interrupts.h"
#include "sim/avr/surroundings.h"
#include "sim/avr/triggers.h"
#include "sim/avr/visitor.h"
#include "sim/base/kept.h"

namespace robosim::avr {

/// A part of the chip with its own registers.
class Peripheral {
 public:
  virtual ~Peripheral() = default;
  /// As after power-on: its registers hold their initial values (the processor has put 0 into all of them),
  /// its events are cancelled and its requests taken back already.
  virtual void reset(Cycle at) = 0;
  /// Its clock stands still from `at` on, or runs on: a sleep mode, or its bit in PRR.
  virtual void clock_runs(bool runs, Cycle at) {
    (void)runs;
    (void)at;
  }
  /// The processor falls asleep, in a mode that keeps the ADC's clock running or in another. Its own clock
  /// may stop next. Told to what has that clock.
  virtual void falls_asleep(bool adc_clock_runs, Cycle at) {
    (void)adc_clock_runs;
    (void)at;
  }
  /// Interrupts that are enabled and may come though firmware touches none of its registers; a bit a vector.
  virtual std::uint64_t may_interrupt() const { return 0; }
};

struct Core {
  Core(const ChipSpec& spec, std::span<const std::uint8_t> flash, Address last_ram, Surroundings& around,
       std::int64_t oscillator)
      : chip(spec),
        cpu(spec, flash, last_ram),
        outside(around),
        oscillator_hz(oscillator),
        clock_hz(oscillator) {
    cpu.waiting = &interrupts.state;
    keep(cpu.state);
    kept.add_memory(cpu.data);
    keep(events.state);
    keep(interrupts.state);
    keep(triggers.state);
    keep(clock_hz);
    keep(reset_may_come);
  }

  Cycle now() const { return cpu.cycle(); }
  std::uint8_t& at(Address address) { return cpu.data[address]; }

  /// An event at `cycle`, which may be sooner than the processor was told to run to.
  void schedule(Events::Id id, Cycle cycle) {
    events.schedule(id, cycle);
    cpu.look_up();
  }
  /// When the clock stopped that an event waits for, and when it was due.
  struct Held {
    Cycle since = 0, due = kNoCycle;
  };
  /// An event does not come while its peripheral's clock stands still, and comes so much later when it goes
  /// on.
  void hold(Events::Id id, Held& held, Cycle at) {
    held = {at, events.due(id)};
    events.cancel(id);
  }
  void go_on(Events::Id id, const Held& held, Cycle at) {
    if (held.due != kNoCycle) schedule(id, held.due + (at - held.since));
  }
  /// Either, as the clock stops or runs on.
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

  /// What `vector` tells of came again before its handler did, and nobody will know.
  void lose(int vector) const {
    if (on_lost) on_lost(on_lost_self, vector);
  }

  /// Cycles of the processor in a time, not less.
  Cycle cycles(std::int64_t nanoseconds) const {
    constexpr std::int64_t kSecond = 1'000'000'000;
    return static_cast<Cycle>((nanoseconds * clock_hz + kSecond - 1) / kSecond);
  }
  /// The processor's clock runs at the oscillator's divided by `divisor` from now on.
  void divide_clock(int divisor) {
    const std::int64_t before = clock_hz;
    clock_hz = oscillator_hz / divisor;
    if (clock_hz == before) return;
    for (const ClockChange& change : clock_changes_) change.call(change.self, before);
  }
  /// void Owner::Method(std::int64_t hz_before) is called when the processor's clock has changed: what takes
  /// a time of its own takes another number of cycles.
  template <auto Method, typename Owner>
  void on_clock_change(Owner* owner) {
    clock_changes_.push_back(
        {[](void* self, std::int64_t before) { (static_cast<Owner*>(self)->*Method)(before); }, owner});
  }
  /// `at`, which was cycles of a clock of `hz_before`, in cycles of the processor's clock of now.
  Cycle rescaled(Cycle at, std::int64_t hz_before) const {
    if (at == kNoCycle || at <= now()) return at;
    const auto before = static_cast<Cycle>(hz_before);
    return now() + ((at - now()) * static_cast<Cycle>(clock_hz) + before - 1) / before;
  }

  /// `state` is a part of what changes while the chip runs: snapshots copy it byte by byte.
  template <typename State>
  void keep(State& state) {
    static_assert(std::is_trivially_copyable_v<State>);
    kept.add(state);
  }

  const ChipSpec& chip;
  Cpu cpu;
  Events events;
  Interrupts interrupts;
  Triggers triggers;
  Surroundings& outside;
  const std::int64_t oscillator_hz;
  std::int64_t clock_hz;      ///< the processor's: the oscillator's, divided by CLKPR
  double supply_volts = 5.0;  ///< AVCC has them too. Whoever uses the chip may set them.
  Kept kept;
  Visitor* visitor = nullptr;  ///< of marks; null = they stop the chip
  /// A reset may come though interrupts are off: the watchdog's.
  bool reset_may_come = false;
  /// The chip resets itself behind the instruction that runs; `flags` are MCUSR's. Set by the chip.
  void (*reset)(void* self, std::uint8_t flags) = nullptr;
  void* reset_self = nullptr;
  /// Who wants to know what is lost; may be null.
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
