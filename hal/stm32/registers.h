// Provides register access for firmware, and the few instructions that C++ cannot express. In tests on a PC,
// a model of the chip replaces both.
//
//   at(kRccCr) |= kHseOn;
#pragma once

#include "hal/stm32/addresses.h"

namespace robosim {
namespace stm32 {

#ifdef ROBOSIM_STM32_MODEL
uint32_t load(Address address);
void store(Address address, uint32_t value);
uint16_t load_half(Address address);
void store_half(Address address, uint16_t value);
bool disable_interrupts();
void restore_interrupts(bool enabled);
bool takes_interrupts();
void wait_for_interrupt();
#else
inline uint32_t load(Address address) { return *reinterpret_cast<volatile uint32_t*>(address); }
inline void store(Address address, uint32_t value) { *reinterpret_cast<volatile uint32_t*>(address) = value; }
/// Access half words: flash is programmed in half words.
inline uint16_t load_half(Address address) { return *reinterpret_cast<volatile uint16_t*>(address); }
inline void store_half(Address address, uint16_t value) {
  *reinterpret_cast<volatile uint16_t*>(address) = value;
}
/// Disables interrupts, and returns whether they were enabled.
inline bool disable_interrupts() {
  uint32_t masked;
  __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(masked)::"memory");
  return masked == 0;
}
inline void restore_interrupts(bool enabled) {
  if (enabled) __asm__ volatile("cpsie i" ::: "memory");
}
/// Returns whether interrupts are on and no handler is running. Otherwise a sleep might never end.
inline bool takes_interrupts() {
  uint32_t masked, handler;
  __asm__ volatile("mrs %0, primask\n\tmrs %1, ipsr" : "=r"(masked), "=r"(handler));
  return masked == 0 && handler == 0;
}
/// Sleeps until an interrupt. An interrupt that PRIMASK masks also ends the sleep, without a call of its
/// handler (PM0056 2.5.2).
inline void wait_for_interrupt() { __asm__ volatile("wfi" ::: "memory"); }
#endif

class Register {
 public:
  explicit constexpr Register(Address address) : address_(address) {}
  operator uint32_t() const { return load(address_); }
  void operator=(uint32_t value) const { store(address_, value); }
  void operator|=(uint32_t bits) const { store(address_, load(address_) | bits); }
  void operator&=(uint32_t bits) const { store(address_, load(address_) & bits); }
  /// Writes `value` to the bits of `mask` only.
  void set(uint32_t mask, uint32_t value) const { store(address_, (load(address_) & ~mask) | value); }
  void await(uint32_t mask, uint32_t value) const {
    while ((load(address_) & mask) != value) {
    }
  }

 private:
  Address address_;
};

constexpr Register at(Address address) { return Register(address); }

/// Disables interrupts while the object exists.
class Quiet {
 public:
  Quiet() : were_on_(disable_interrupts()) {}
  ~Quiet() { restore_interrupts(were_on_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  bool were_on_;
};

/// Enables the interrupt in the processor.
inline void enable_irq(Irq irq) { at(kNvicIser + 4u * (irq / 32u)) = 1u << (irq % 32u); }

}  // namespace stm32
}  // namespace robosim
