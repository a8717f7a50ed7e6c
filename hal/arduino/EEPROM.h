// The EEPROM library: stores bytes that survive power-off. It has the API of the AVR core's library.
//
//   EEPROM.put(0, gains);   // accepts any plain type; writes only bytes that differ
//   EEPROM.get(0, gains);
//   EEPROM[10] = 7;         // one byte
#pragma once
#ifndef EEPROM_h
#define EEPROM_h

#include <avr/eeprom.h>
#include <avr/io.h>
#include <inttypes.h>

/// Refers to one byte of EEPROM by its address.
struct EERef {
  EERef(const int address) : index(address) {}

  uint8_t operator*() const { return robosim_eeprom_read(static_cast<uint16_t>(index)); }
  operator uint8_t() const { return **this; }

  EERef& operator=(const EERef& other) { return *this = *other; }
  EERef& operator=(uint8_t value) {
    robosim_eeprom_write(static_cast<uint16_t>(index), value);
    return *this;
  }
  EERef& operator+=(uint8_t value) { return *this = static_cast<uint8_t>(**this + value); }
  EERef& operator-=(uint8_t value) { return *this = static_cast<uint8_t>(**this - value); }
  EERef& operator*=(uint8_t value) { return *this = static_cast<uint8_t>(**this * value); }
  EERef& operator/=(uint8_t value) { return *this = static_cast<uint8_t>(**this / value); }
  EERef& operator%=(uint8_t value) { return *this = static_cast<uint8_t>(**this % value); }
  EERef& operator^=(uint8_t value) { return *this = static_cast<uint8_t>(**this ^ value); }
  EERef& operator&=(uint8_t value) { return *this = static_cast<uint8_t>(**this & value); }
  EERef& operator|=(uint8_t value) { return *this = static_cast<uint8_t>(**this | value); }
  EERef& operator<<=(uint8_t bits) { return *this = static_cast<uint8_t>(**this << bits); }
  EERef& operator>>=(uint8_t bits) { return *this = static_cast<uint8_t>(**this >> bits); }
  EERef& operator++() { return *this += 1; }
  EERef& operator--() { return *this -= 1; }
  uint8_t operator++(int) {
    const uint8_t before = **this;
    ++*this;
    return before;
  }
  uint8_t operator--(int) {
    const uint8_t before = **this;
    --*this;
    return before;
  }
  /// Writes `value` only if the stored byte differs.
  EERef& update(uint8_t value) { return **this != value ? *this = value : *this; }

  int index;
};

/// Iterates over EEPROM bytes.
struct EEPtr {
  EEPtr(const int address) : index(address) {}

  operator int() const { return index; }
  EEPtr& operator=(int address) {
    index = address;
    return *this;
  }
  bool operator!=(const EEPtr& other) { return index != other.index; }
  EERef operator*() { return index; }
  EEPtr& operator++() {
    ++index;
    return *this;
  }
  EEPtr& operator--() {
    --index;
    return *this;
  }
  EEPtr operator++(int) { return index++; }
  EEPtr operator--(int) { return index--; }

  int index;
};

struct EEPROMClass {
  EERef operator[](const int address) { return address; }
  uint8_t read(int address) { return EERef(address); }
  void write(int address, uint8_t value) { robosim_eeprom_write(static_cast<uint16_t>(address), value); }
  void update(int address, uint8_t value) { EERef(address).update(value); }

  EEPtr begin() { return 0; }
  EEPtr end() { return length(); }
  uint16_t length() { return E2END + 1; }

  template <typename T>
  T& get(int address, T& value) {
    uint8_t* bytes = (uint8_t*)&value;  // the cast also removes volatile
    for (unsigned i = 0; i < sizeof value; ++i) bytes[i] = read(address + static_cast<int>(i));
    return value;
  }
  template <typename T>
  const T& put(int address, const T& value) {
    const uint8_t* bytes = (const uint8_t*)&value;
    for (unsigned i = 0; i < sizeof value; ++i) update(address + static_cast<int>(i), bytes[i]);
    return value;
  }
};

static EEPROMClass EEPROM __attribute__((unused));

#endif  // EEPROM_h
