// What the bus sees of a peripheral: registers at addresses, and when it next does something by itself.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// What somebody who looks at a pin that makes PWM sees: its level now, and the cycle up to which, exclusive,
/// that stays so if nothing is written; the present one or one before: not known.
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

  /// The word at `address`, at the present time; 0 where there is no register.
  virtual std::uint32_t read(Address address) = 0;
  /// False for what is not modelled.
  virtual bool write(Address address, std::uint32_t value) = 0;
  /// As after power-on: what of it begins at `block`.
  virtual void reset(Address block) = 0;

  /// When update() next has something to do; kNoCycle if it will not.
  virtual Cycle next_event() const { return kNoCycle; }
  /// Until which cycle, exclusive, read() surely gives what it gives now, and changes nothing, so that nobody
  /// misses reads that are left out: as long as nothing is written, no input comes, and update() has nothing
  /// to do. The present cycle, or one before: that is not known.
  virtual Cycle same_until(Address) const { return 0; }
  /// Brings it up to the present time.
  virtual void update() {}
  /// Whether what update() does changes no other's next_event(), but by a signal or a DMA request.
  virtual bool acts_alone() const { return false; }

  /// The DMA channels whose service it asks for: dma_channel() of each.
  virtual unsigned dma_requests() const { return 0; }
  virtual void dma_served(int) {}

  /// At which signals heard() has something to do.
  virtual Signals listens() const { return 0; }
  virtual void heard(Signals) {}

  /// Whether it has that pin, by AFIO_MAPR as it is; then `drive` is how it drives it.
  virtual bool drives(ChipPin, PinDrive&) const { return false; }

  /// Of a pin that drives() tells PWM of.
  virtual Pulse pulse(ChipPin) const { return {}; }

  /// Whether it wants to hear of the pin's edges; then edge() tells it.
  virtual bool watches(ChipPin) const { return false; }
  virtual void edge(ChipPin, bool, Cycle) {}

  std::size_t bus_index = 0;  ///< among the bus's
  Signals noted_signals = 0;  ///< listens(), as the bus knows it
};

}  // namespace robosim::exec::stm32
