// Implements the event queue of a chip: the future actions of peripherals, and the cycles at which they are
// due.
//
//   id = events.add<&Timer::overflow>(this);      // once, when the chip is made
//   events.schedule(id, cycle);                   // any number of times; a new time replaces the old one
//
// Events at the same cycle occur in the order in which they were added.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

class Events {
 public:
  using Id = std::uint8_t;
  static constexpr std::size_t kMost = 48;

  /// All state that changes while the chip runs; snapshots copy it.
  struct State {
    std::array<Cycle, kMost> due;
    Cycle next = kNoCycle;
    std::uint64_t scheduled = 0;  ///< one bit per scheduled event
    State() { due.fill(kNoCycle); }
  };

  /// Registers an event, which calls `Method` of `owner` with the event's due cycle. When the event occurs,
  /// the processor may already be a few cycles later, in the middle of an instruction.
  template <auto Method, typename Owner>
  Id add(Owner* owner) {
    if (count_ == kMost) throw std::logic_error("too many events: expected at most " + std::to_string(kMost));
    actions_[count_] = {[](void* self, Cycle at) { (static_cast<Owner*>(self)->*Method)(at); }, owner};
    return static_cast<Id>(count_++);
  }

  void schedule(Id id, Cycle at) {
    const Cycle before = state.due[id];
    state.due[id] = at;
    if (at == kNoCycle) {
      state.scheduled &= ~bit(id);
    } else {
      state.scheduled |= bit(id);
    }
    if (at <= state.next) {
      state.next = at;
    } else if (before == state.next) {
      find_next();
    }
  }
  void cancel(Id id) { schedule(id, kNoCycle); }
  void cancel_all() { state = {}; }
  /// Returns the cycle at which an event is due; kNoCycle if the event is not scheduled.
  Cycle due(Id id) const { return state.due[id]; }
  /// Returns the cycle at which the next event is due.
  Cycle next() const { return state.next; }
  /// Allows one event to occur late, after a sleep or a skipped loop. The event must have no effect on the
  /// chip. As long as no instruction runs, it must not matter when the event occurs.
  void let_wait(Id id) { waits_ = id; }
  /// Returns the due cycle of the next event, except the event that may occur late (let_wait()).
  Cycle next_urgent() const {
    if (waits_ == kNone || state.due[waits_] != state.next) return state.next;
    Cycle next = kNoCycle;
    each_scheduled([&](std::size_t id) {
      if (id != waits_ && state.due[id] < next) next = state.due[id];
    });
    return next;
  }

  /// Runs all events that are due by `now`, in order of time.
  void run(Cycle now) {
    while (state.next <= now) {
      const Cycle at = state.next;
      const std::size_t id = first_due(at);
      state.due[id] = kNoCycle;
      state.scheduled &= ~bit(id);
      find_next();
      actions_[id].call(actions_[id].self, at);
    }
  }

  State state;

 private:
  struct Action {
    void (*call)(void* self, Cycle at) = nullptr;
    void* self = nullptr;
  };

  static constexpr std::uint64_t bit(std::size_t id) { return std::uint64_t{1} << id; }

  /// Visits the scheduled events in the order in which they were added.
  template <typename Visit>
  void each_scheduled(Visit visit) const {
    for (std::uint64_t rest = state.scheduled; rest; rest &= rest - 1)
      visit(static_cast<std::size_t>(std::countr_zero(rest)));
  }
  std::size_t first_due(Cycle at) const {
    std::uint64_t rest = state.scheduled;
    while (state.due[static_cast<std::size_t>(std::countr_zero(rest))] != at) rest &= rest - 1;
    return static_cast<std::size_t>(std::countr_zero(rest));
  }
  void find_next() {
    state.next = kNoCycle;
    each_scheduled([&](std::size_t id) {
      if (state.due[id] < state.next) state.next = state.due[id];
    });
  }

  static constexpr Id kNone = 0xFF;

  std::array<Action, kMost> actions_{};
  std::size_t count_ = 0;
  Id waits_ = kNone;
};

}  // namespace robosim::avr
