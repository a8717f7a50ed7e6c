// Defines the interface between the bus and a peripheral: registers at addresses, and the time of the next
// event.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// The level of a pin with PWM. The level stays constant before the cycle `until`, if no register is written.
/// If `until` is not after the present cycle, the time of the next change is unknown.
struct Pulse {
  bool level = false;
  Cycle until = 0;
};

/// Returns the bit of DMA channel `number`, 1 to 7.
constexpr unsigned dma_channel(int number) { return 1u << (number - 1); }

class Peripheral {
 public:
  Peripheral() = default;
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;
  virtual ~Peripheral() = default;

  /// Reads the register at `address` at the present time. Returns 0 if there is no register.
  virtual std::uint32_t read(Address address) = 0;
  /// Writes the register at `address`. Returns false if the write is not modelled.
  virtual bool write(Address address, std::uint32_t value) = 0;
  /// Resets the registers of the block that begins at `block`, as after power-on.
  virtual void reset(Address block) = 0;

  /// Returns the next cycle at which update() must be called; kNoCycle if no call is necessary.
  virtual Cycle next_event() const { return kNoCycle; }
  /// Returns the first cycle at which read() may return another value or have side effects. Earlier reads can
  /// be skipped. The result is valid until the next write, input or event. If the result is not after the
  /// present cycle, the time of the next change is unknown.
  virtual Cycle same_until(Address) const { return 0; }
  /// Advances the peripheral to the present time.
  virtual void update() {}
  /// Returns whether update() affects next_event() of other peripherals only by signals and DMA requests.
  virtual bool acts_alone() const { return false; }

  /// Returns the DMA channels that the peripheral requests, as a set of dma_channel() bits.
  virtual unsigned dma_requests() const { return 0; }
  virtual void dma_served(int) {}

  /// Returns the signals for which heard() must be called.
  virtual Signals listens() const { return 0; }
  virtual void heard(Signals) {}

  /// Returns whether the peripheral owns the pin under the present AFIO_MAPR. If so, sets `drive` to the way
  /// in which the peripheral drives the pin.
  virtual bool drives(ChipPin, PinDrive&) const { return false; }

  /// Returns the pulse of a pin for which drives() reports PWM.
  virtual Pulse pulse(ChipPin) const { return {}; }

  /// Returns whether edges of the pin must be reported to edge().
  virtual bool watches(ChipPin) const { return false; }
  virtual void edge(ChipPin, bool, Cycle) {}

  std::size_t bus_index = 0;  ///< index of this peripheral in Bus::peripherals_
  Signals noted_signals = 0;  ///< last result of listens() that the bus has stored
};

}  // namespace robosim::exec::stm32
