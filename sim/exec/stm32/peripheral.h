// The bus's interface to a peripheral: registers at addresses, and the time of its next own action.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// The view of a pin with PWM: its level now, and the cycle up to which, exclusive, it stays unless something
/// is written. The present cycle or an earlier one: unknown.
struct Pulse {
  bool level = false;
  Cycle until = 0;
};

/// `number`: 1 to 7.
constexpr unsigned dma_channel(int number) { return 1u << (number - 1); }

class Peripheral {
 public:
  Peripheral() = default;
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;
  virtual ~Peripheral() = default;

  /// Returns the word at `address`, at the present time; 0 where there is no register.
  virtual std::uint32_t read(Address address) = 0;
  /// Returns false for what is not modelled.
  virtual bool write(Address address, std::uint32_t value) = 0;
  /// Resets the part that begins at `block`, as after power-on.
  virtual void reset(Address block) = 0;

  /// Returns when update() next has work; kNoCycle if never.
  virtual Cycle next_event() const { return kNoCycle; }
  /// Returns until which cycle, exclusive, read() surely returns its present value without side effects, so
  /// that reads can be skipped. Holds while nothing is written, no input comes, and update() has no work. The
  /// present cycle, or an earlier one: unknown.
  virtual Cycle same_until(Address) const { return 0; }
  /// Brings it up to the present time.
  virtual void update() {}
  /// Returns whether update() changes no other peripheral's next_event(), except by a signal or a DMA
  /// request.
  virtual bool acts_alone() const { return false; }

  /// Returns the DMA channels whose service it requests: dma_channel() of each.
  virtual unsigned dma_requests() const { return 0; }
  virtual void dma_served(int) {}

  /// Returns the signals for which heard() has work.
  virtual Signals listens() const { return 0; }
  virtual void heard(Signals) {}

  /// Returns whether it has that pin, by the present AFIO_MAPR; sets `drive` to how it drives the pin.
  virtual bool drives(ChipPin, PinDrive&) const { return false; }

  /// Returns the pulse of a pin for which drives() reports PWM.
  virtual Pulse pulse(ChipPin) const { return {}; }

  /// Returns whether it needs the pin's edges; edge() then reports them.
  virtual bool watches(ChipPin) const { return false; }
  virtual void edge(ChipPin, bool, Cycle) {}

  std::size_t bus_index = 0;  ///< index in the bus
  Signals noted_signals = 0;  ///< listens(), as stored in the bus
};

}  // namespace robosim::exec::stm32
