// avr-libc's cyclic redundancy checks. Each function adds one byte to a checksum, and returns the new
// checksum. The function shifts the byte's bits through a register with feedback, as its polynomial defines.
#pragma once

#include <stdint.h>

static inline uint16_t robosim_crc_right(uint16_t crc, uint8_t byte, uint16_t polynomial) {
  crc ^= byte;
  for (uint8_t i = 0; i < 8; ++i) crc = (uint16_t)(crc & 1 ? (crc >> 1) ^ polynomial : crc >> 1);
  return crc;
}

/// Computes CRC-16 (Modbus, USB): x^16 + x^15 + x^2 + 1, least significant bit first.
static inline uint16_t _crc16_update(uint16_t crc, uint8_t byte) {
  return robosim_crc_right(crc, byte, 0xA001);
}
/// Computes CRC-CCITT (PPP, IrDA): x^16 + x^12 + x^5 + 1, least significant bit first.
static inline uint16_t _crc_ccitt_update(uint16_t crc, uint8_t byte) {
  return robosim_crc_right(crc, byte, 0x8408);
}
/// Computes the checksum of Dallas 1-Wire: x^8 + x^5 + x^4 + 1, least significant bit first.
static inline uint8_t _crc_ibutton_update(uint8_t crc, uint8_t byte) {
  return (uint8_t)robosim_crc_right(crc, byte, 0x8C);
}
/// Computes the checksum of XMODEM: x^16 + x^12 + x^5 + 1, most significant bit first.
static inline uint16_t _crc_xmodem_update(uint16_t crc, uint8_t byte) {
  crc = (uint16_t)(crc ^ byte << 8);
  for (uint8_t i = 0; i < 8; ++i) crc = (uint16_t)(crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1);
  return crc;
}
/// Computes CRC-8-CCITT (SMBus): x^8 + x^2 + x + 1, most significant bit first.
static inline uint8_t _crc8_ccitt_update(uint8_t crc, uint8_t byte) {
  crc ^= byte;
  for (uint8_t i = 0; i < 8; ++i) crc = (uint8_t)(crc & 0x80 ? crc << 1 ^ 0x07 : crc << 1);
  return crc;
}
