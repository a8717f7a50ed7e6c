// Flags that start something elsewhere in the chip, as a timer's match starts a conversion of the ADC. A flag
// is named by the vector of its interrupt. One peripheral at a time waits, for one flag.
//
//   core.triggers.offer<&Timer::awaited>(vector, this);   // once: this peripheral owns the flag
//   core.triggers.raised(vector, at);                     // when the flag is set; cheap if not awaited
//
// A peripheral that computes its flags only on demand must compute an awaited flag in time.
#pragma once

#include <array>
#include <cstddef>

#include "sim/avr/cycle.h"
#include "sim/avr/interrupts.h"

namespace robosim::avr {

class AdcTriggers {
 public:
  static constexpr int kNone = 0;  ///< the reset's vector: not awaited

  /// Offers a flag by bool Owner::Method(int vector, bool awaited): starts or stops waiting for it. Returns
  /// whether it is set now.
  template <auto Method, typename Owner>
  void offer(int vector, Owner* owner) {
    offers_[static_cast<std::size_t>(vector)] = {[](void* self, int number, bool awaited) {
                                                   return (static_cast<Owner*>(self)->*Method)(number,
                                                                                               awaited);
                                                 },
                                                 owner};
  }
  /// Reports that the flag is set, and was not before.
  void raised(int vector, Cycle at) const {
    if (vector == state.awaited && started_.call) started_.call(started_.self, at);
  }
  bool is_awaited(int vector) const { return vector == state.awaited; }

  // --- for the waiting peripheral
  /// Registers void Owner::Method(Cycle)
  template <auto Method, typename Owner>
  void on_trigger(Owner* owner) {
    started_ = {[](void* self, Cycle at) { (static_cast<Owner*>(self)->*Method)(at); }, owner};
  }
  /// Starts to wait; returns whether the flag is set already.
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
