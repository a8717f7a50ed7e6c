// Defines the chip's registers by the names that sketches use: PORTB, TCCR1A, ADC, ...
//
// Names, addresses and bits come from avr-libc's header for the chip, such as iom328p.h. Each access to a
// register calls the simulated chip (hal/host). Therefore a register is an object with overloaded operators
// for reads, assignments and changes.
//
// Some programs need more: a register's address as a `volatile uint8_t*`, or a register in a .c file. The
// build compiles these programs again with ROBOSIM_REGISTER_MEMORY. Registers are then bytes of memory, and
// accesses to memory are observed (hal/host/register_memory.h).
#pragma once
#define _AVR_IO_H_

#include <stdint.h>

#include "hal/host/registers.h"

#define _BV(bit) (1 << (bit))
#define _VECTOR(number) __vector_##number

#if defined(__cplusplus) && !defined(ROBOSIM_REGISTER_MEMORY)

namespace robosim_hal {

class RegisterPointer;

/// A register with 8 bits.
class Register8 {
 public:
  explicit constexpr Register8(robosim_register address) : address_(address) {}
  constexpr Register8(const Register8&) = default;

  operator uint8_t() const { return robosim_read8(address_); }
  template <typename T>
  uint8_t operator=(T value) const {
    return store(static_cast<uint8_t>(value));
  }
  uint8_t operator=(const Register8& other) const { return store(other); }
  template <typename T>
  __attribute__((always_inline)) inline uint8_t operator|=(T value) const {
    const auto bits = static_cast<uint8_t>(value);
    if (__builtin_constant_p(address_) && __builtin_constant_p(bits) && changes_bit(bits)) return store(bits);
    return store(static_cast<uint8_t>(load() | bits));
  }
  template <typename T>
  __attribute__((always_inline)) inline uint8_t operator&=(T value) const {
    const auto bits = static_cast<uint8_t>(value), cleared = static_cast<uint8_t>(~bits);
    if (__builtin_constant_p(address_) && __builtin_constant_p(cleared) && changes_bit(cleared))
      return store(0);
    return store(static_cast<uint8_t>(load() & bits));
  }
  template <typename T>
  uint8_t operator^=(T value) const {
    return store(static_cast<uint8_t>(load() ^ static_cast<uint8_t>(value)));
  }
  template <typename T>
  uint8_t operator+=(T value) const {
    return store(static_cast<uint8_t>(load() + value));
  }
  template <typename T>
  uint8_t operator-=(T value) const {
    return store(static_cast<uint8_t>(load() - value));
  }
  uint8_t operator<<=(int bits) const { return store(static_cast<uint8_t>(load() << bits)); }
  uint8_t operator>>=(int bits) const { return store(static_cast<uint8_t>(load() >> bits)); }
  uint8_t operator++() const { return store(static_cast<uint8_t>(load() + 1)); }
  uint8_t operator--() const { return store(static_cast<uint8_t>(load() - 1)); }
  uint8_t operator++(int) const { return static_cast<uint8_t>(++*this - 1); }
  uint8_t operator--(int) const { return static_cast<uint8_t>(--*this + 1); }
  constexpr RegisterPointer operator&() const;

 private:
  /// Returns whether `bits` is one bit of a register that reacts only to bits written as 1: PINx, TIFRn,
  /// PCIFR, EIFR. For a constant register and bit, avr-gcc compiles `|=` and `&=` to the instructions SBI and
  /// CBI, which write only that bit. Here, the operators must also write only that bit.
  constexpr bool changes_bit(uint8_t bits) const {
    return (address_ == 0x23 || address_ == 0x26 || address_ == 0x29 ||
            (address_ >= 0x35 && address_ <= 0x37) || address_ == 0x3B || address_ == 0x3C) &&
           bits != 0 && (bits & (bits - 1)) == 0;
  }
  uint8_t load() const { return robosim_read8(address_); }
  uint8_t store(uint8_t value) const {
    robosim_write8(address_, value);
    return value;
  }

  robosim_register address_;
};

/// The type of `&PORTB` and portOutputRegister(). If `p` has this type, `*p |= mask` works. A program that
/// converts this type to a `volatile uint8_t*` references robosim_register_memory, so the build compiles the
/// program again.
class RegisterPointer {
 public:
  constexpr RegisterPointer() : address_(0) {}
  explicit constexpr RegisterPointer(robosim_register address) : address_(address) {}
  constexpr Register8 operator*() const { return Register8(address_); }
  explicit constexpr operator bool() const { return address_ != 0; }
  operator volatile uint8_t*() const { return robosim_register_memory + address_; }
  explicit operator uint8_t*() const { return robosim_register_memory + address_; }

 private:
  robosim_register address_;
};

constexpr RegisterPointer Register8::operator&() const { return RegisterPointer(address_); }

#define ROBOSIM_INLINE __attribute__((always_inline)) inline

/// A register for which a read has side effects. A program may read the register and ignore the value:
/// `(void)UDR0;`, `SPSR;`. The destructor therefore reads the register, unless the statement has already
/// accessed the register.
class ReadRegister8 {
 public:
  ROBOSIM_INLINE explicit ReadRegister8(robosim_register address) : register_(address) {}
  ROBOSIM_INLINE ReadRegister8(const ReadRegister8& other) : register_(other.use()) {}
  ROBOSIM_INLINE ~ReadRegister8() {
    if (!used_) static_cast<void>(static_cast<uint8_t>(register_));
  }

  ROBOSIM_INLINE operator uint8_t() const { return use(); }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator=(T value) const {
    return use() = value;
  }
  ROBOSIM_INLINE uint8_t operator=(const ReadRegister8& other) const { return use() = other.use(); }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator|=(T value) const {
    return use() |= value;
  }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator&=(T value) const {
    return use() &= value;
  }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator^=(T value) const {
    return use() ^= value;
  }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator+=(T value) const {
    return use() += value;
  }
  template <typename T>
  ROBOSIM_INLINE uint8_t operator-=(T value) const {
    return use() -= value;
  }
  ROBOSIM_INLINE uint8_t operator<<=(int bits) const { return use() <<= bits; }
  ROBOSIM_INLINE uint8_t operator>>=(int bits) const { return use() >>= bits; }
  ROBOSIM_INLINE uint8_t operator++() const { return ++use(); }
  ROBOSIM_INLINE uint8_t operator--() const { return --use(); }
  ROBOSIM_INLINE uint8_t operator++(int) const { return use()++; }
  ROBOSIM_INLINE uint8_t operator--(int) const { return use()--; }
  ROBOSIM_INLINE RegisterPointer operator&() const { return &use(); }

 private:
  ROBOSIM_INLINE const Register8& use() const {
    used_ = true;
    return register_;
  }

  Register8 register_;
  mutable bool used_ = false;
};

/// A 16-bit register. An access reads or writes both bytes at once, like an access through TEMP on the chip.
class Register16 {
 public:
  explicit constexpr Register16(robosim_register address) : address_(address) {}
  constexpr Register16(const Register16&) = default;

  operator uint16_t() const { return robosim_read16(address_); }
  template <typename T>
  uint16_t operator=(T value) const {
    return store(static_cast<uint16_t>(value));
  }
  uint16_t operator=(const Register16& other) const { return store(other); }
  template <typename T>
  uint16_t operator|=(T value) const {
    return store(static_cast<uint16_t>(load() | static_cast<uint16_t>(value)));
  }
  template <typename T>
  uint16_t operator&=(T value) const {
    return store(static_cast<uint16_t>(load() & static_cast<uint16_t>(value)));
  }
  template <typename T>
  uint16_t operator^=(T value) const {
    return store(static_cast<uint16_t>(load() ^ static_cast<uint16_t>(value)));
  }
  template <typename T>
  uint16_t operator+=(T value) const {
    return store(static_cast<uint16_t>(load() + value));
  }
  template <typename T>
  uint16_t operator-=(T value) const {
    return store(static_cast<uint16_t>(load() - value));
  }
  uint16_t operator<<=(int bits) const { return store(static_cast<uint16_t>(load() << bits)); }
  uint16_t operator>>=(int bits) const { return store(static_cast<uint16_t>(load() >> bits)); }
  uint16_t operator++() const { return store(static_cast<uint16_t>(load() + 1)); }
  uint16_t operator--() const { return store(static_cast<uint16_t>(load() - 1)); }
  uint16_t operator++(int) const { return static_cast<uint16_t>(++*this - 1); }
  uint16_t operator--(int) const { return static_cast<uint16_t>(--*this + 1); }

 private:
  uint16_t load() const { return robosim_read16(address_); }
  uint16_t store(uint16_t value) const {
    robosim_write16(address_, value);
    return value;
  }

  robosim_register address_;
};

}  // namespace robosim_hal

#define _SFR_MEM8(address) (robosim_hal::Register8(address))
#define _SFR_MEM16(address) (robosim_hal::Register16(address))

#else  // With ROBOSIM_REGISTER_MEMORY, or in C, which cannot overload operators, registers are memory.

#define ROBOSIM_REGISTER(type, address) (*(volatile type*)(robosim_register_memory + (address)))
#define _SFR_MEM8(address) ROBOSIM_REGISTER(uint8_t, address)
#define _SFR_MEM16(address) ROBOSIM_REGISTER(uint16_t, address)
#define _SFR_MEM_ADDR(sfr) ((uintptr_t) & (sfr) - (uintptr_t)robosim_register_memory)
#define _SFR_IO_ADDR(sfr) (_SFR_MEM_ADDR(sfr) - 0x20)
#define _SFR_ADDR(sfr) _SFR_MEM_ADDR(sfr)
#define _SFR_IO_REG_P(sfr) (_SFR_MEM_ADDR(sfr) < 0x60)

#endif

#define _SFR_IO8(address) _SFR_MEM8((address) + 0x20)
#define _SFR_IO16(address) _SFR_MEM16((address) + 0x20)
#define _SFR_BYTE(sfr) (sfr)
#define _SFR_WORD(sfr) (sfr)

#define bit_is_set(sfr, bit) ((sfr)&_BV(bit))
#define bit_is_clear(sfr, bit) (!((sfr)&_BV(bit)))
#define loop_until_bit_is_set(sfr, bit) \
  do {                                  \
  } while (bit_is_clear(sfr, bit))
#define loop_until_bit_is_clear(sfr, bit) \
  do {                                    \
  } while (bit_is_set(sfr, bit))

#define SREG _SFR_IO8(0x3F)
#define SP _SFR_IO16(0x3D)
#define SPL _SFR_IO8(0x3D)
#define SPH _SFR_IO8(0x3E)
#define SREG_C 0
#define SREG_Z 1
#define SREG_N 2
#define SREG_V 3
#define SREG_S 4
#define SREG_H 5
#define SREG_T 6
#define SREG_I 7

#include ROBOSIM_REGISTERS
#include <avr/portpins.h>

#if defined(__cplusplus) && !defined(ROBOSIM_REGISTER_MEMORY)
#undef TCNT1L
#define TCNT1L (robosim_hal::ReadRegister8(0x84))
#undef ICR1L
#define ICR1L (robosim_hal::ReadRegister8(0x86))
#undef UDR0
#define UDR0 (robosim_hal::ReadRegister8(0xC6))
#undef SPSR
#define SPSR (robosim_hal::ReadRegister8(0x4D))
#undef SPDR
#define SPDR (robosim_hal::ReadRegister8(0x4E))
#undef ADCL
#define ADCL (robosim_hal::ReadRegister8(0x78))
#undef ADCH
#define ADCH (robosim_hal::ReadRegister8(0x79))
#endif
