// Implements avr-libc's EEPROM functions.
#include <avr/eeprom.h>

extern "C" {
// The bounds of the linker section that contains the EEMEM variables; null if there are no such variables.
extern const uint8_t __start_robosim_eeprom[] __attribute__((weak, visibility("hidden")));
extern const uint8_t __stop_robosim_eeprom[] __attribute__((weak, visibility("hidden")));
}

namespace {

uint16_t eeprom_address(const void* pointer) {
  const auto address = reinterpret_cast<uintptr_t>(pointer);
  const auto start = reinterpret_cast<uintptr_t>(__start_robosim_eeprom);
  const auto stop = reinterpret_cast<uintptr_t>(__stop_robosim_eeprom);
  return static_cast<uint16_t>(start && address >= start && address < stop ? address - start : address);
}

template <typename T>
T read(const T* address) {
  T value;
  eeprom_read_block(&value, address, sizeof value);
  return value;
}

}  // namespace

extern "C" {

void eeprom_read_block(void* to, const void* address, size_t size) {
  uint16_t from = eeprom_address(address);
  for (size_t i = 0; i < size; ++i) static_cast<uint8_t*>(to)[i] = robosim_eeprom_read(from++);
}

void eeprom_write_block(const void* from, void* address, size_t size) {
  uint16_t to = eeprom_address(address);
  for (size_t i = 0; i < size; ++i) robosim_eeprom_write(to++, static_cast<const uint8_t*>(from)[i]);
}

void eeprom_update_block(const void* from, void* address, size_t size) {
  uint16_t to = eeprom_address(address);
  for (size_t i = 0; i < size; ++i, ++to) {
    const uint8_t byte = static_cast<const uint8_t*>(from)[i];
    if (robosim_eeprom_read(to) != byte) robosim_eeprom_write(to, byte);
  }
}

uint8_t eeprom_read_byte(const uint8_t* address) { return read(address); }
uint16_t eeprom_read_word(const uint16_t* address) { return read(address); }
uint32_t eeprom_read_dword(const uint32_t* address) { return read(address); }
float eeprom_read_float(const float* address) { return read(address); }

void eeprom_write_byte(uint8_t* address, uint8_t value) { eeprom_write_block(&value, address, sizeof value); }
void eeprom_write_word(uint16_t* address, uint16_t value) {
  eeprom_write_block(&value, address, sizeof value);
}
void eeprom_write_dword(uint32_t* address, uint32_t value) {
  eeprom_write_block(&value, address, sizeof value);
}
void eeprom_write_float(float* address, float value) { eeprom_write_block(&value, address, sizeof value); }

void eeprom_update_byte(uint8_t* address, uint8_t value) {
  eeprom_update_block(&value, address, sizeof value);
}
void eeprom_update_word(uint16_t* address, uint16_t value) {
  eeprom_update_block(&value, address, sizeof value);
}
void eeprom_update_dword(uint32_t* address, uint32_t value) {
  eeprom_update_block(&value, address, sizeof value);
}
void eeprom_update_float(float* address, float value) { eeprom_update_block(&value, address, sizeof value); }

}  // extern "C"
