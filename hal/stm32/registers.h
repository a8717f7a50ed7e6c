// How firmware accesses a register, and the few instructions that C++ cannot express. In tests on a PC, both
// go to a model of the chip instead.
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
/// Flash is programmed by halves of a word.
inline uint16_t load_half(Address address) { return *reinterpret_cast<volatile uint16_t*>(address); }
inline void store_half(Address address, uint16_t value) {
  *reinterpret_cast<volatile uint16_t*>(address) = value;
}
/// Whether they were on.
inline bool disable_interrupts() {
  uint32_t masked;
  __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(masked)::"memory");
  return masked == 0;
}
inline void restore_interrupts(bool enabled) {
  if (enabled) __asm__ volatile("cpsie i" ::: "memory");
}
/// Whether they are on and no handler runs: else a sleep may have no end.
inline bool takes_interrupts() {
  uint32_t masked, handler;
  __asm__ volatile("mrs %0, primask\n\tmrs %1, ipsr" : "=r"(masked), "=r"(handler));
  return masked == 0 && handler == 0;
}
/// Also wakes, without calling its handler, at an interrupt that is masked by PRIMASK (PM0056 2.5.2).
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

/// Interrupts are off while it lives.
class Quiet {
 public:
  Quiet() : were_on_(disable_interrupts()) {}
  ~Quiet() { restore_interrupts(were_on_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  bool were_on_;
};

/// Lets the interrupt through to the processor.
inline void enable_irq(Irq irq) { at(kNvicIser + 4u * (irq / 32u)) = 1u << (irq % 32u); }

}  // namespace stm32
}  // namespace robosim
