// Connects interrupt flags to the ADC's auto trigger. For example, a timer's compare match can start a
// conversion. Each flag is identified by its interrupt vector. At any time, the ADC waits for at most one
// flag.
//
//   core.triggers.offer<&Timer::awaited>(vector, this);   // once: this peripheral owns the flag
//   core.triggers.raised(vector, at);                     // when the flag is set; cheap if not awaited
//
// A peripheral that computes its flags only on demand must schedule an event for an awaited flag.
#pragma once

#include <array>
#include <cstddef>

#include "sim/mcu/avr/cycle.h"
#include "sim/mcu/avr/interrupts.h"

namespace robosim::avr {

class AdcTriggers {
 public:
  static constexpr int kNone = 0;  ///< the reset vector, which means that no flag is awaited

  /// Registers bool Owner::Method(int vector, bool awaited) for a flag. The method is called when the ADC
  /// starts or stops waiting for the flag. The method returns whether the flag is set.
  template <auto Method, typename Owner>
  void offer(int vector, Owner* owner) {
    offers_[static_cast<std::size_t>(vector)] = {[](void* self, int number, bool awaited) {
                                                   return (static_cast<Owner*>(self)->*Method)(number,
                                                                                               awaited);
                                                 },
                                                 owner};
  }
  /// Reports that the flag has changed from clear to set.
  void raised(int vector, Cycle at) const {
    if (vector == state.awaited && started_.call) started_.call(started_.self, at);
  }

  // --- for the waiting peripheral
  /// Registers void Owner::Method(Cycle), which is called when the awaited flag is set.
  template <auto Method, typename Owner>
  void on_trigger(Owner* owner) {
    started_ = {[](void* self, Cycle at) { (static_cast<Owner*>(self)->*Method)(at); }, owner};
  }
  /// Starts waiting for a flag; returns whether the flag is already set.
  bool await(int vector) {
    if (vector == state.awaited) return tell(vector, true);
    tell(state.awaited, false);
    state.awaited = vector;
    return tell(vector, true);
  }

  struct State {
    int awaited = kNone;
  };
  State state;

 private:
  struct Offer {
    bool (*call)(void* self, int vector, bool awaited) = nullptr;
    void* self = nullptr;
  };
  struct Started {
    void (*call)(void* self, Cycle at) = nullptr;
    void* self = nullptr;
  };
  bool tell(int vector, bool awaited) const {
    const Offer& offer = offers_[static_cast<std::size_t>(vector)];
    return vector != kNone && offer.call && offer.call(offer.self, vector, awaited);
  }

  std::array<Offer, Interrupts::kMost> offers_{};
  Started started_;
};

}  // namespace robosim::avr
