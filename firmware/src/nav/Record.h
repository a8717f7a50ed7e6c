// Reads and writes a record of bytes and bits with a checksum (CRC-16, polynomial 0x1021, most significant
// bit first, as in CCITT). The sink is any type with put(uint8_t). The source is any type with uint8_t get().
// Single bits fill a byte from the lowest bit up. The next put() of a whole byte begins a new byte. A single
// damaged byte is always detected.
#ifndef LINEKIT_NAV_RECORD_H
#define LINEKIT_NAV_RECORD_H

#include <stdint.h>

namespace nav {

inline uint16_t crc16(uint16_t crc, uint8_t byte) {
  crc = static_cast<uint16_t>(crc ^ byte << 8);
  for (uint8_t i = 0; i < 8; ++i) crc = static_cast<uint16_t>(crc << 1 ^ (crc & 0x8000 ? 0x1021 : 0));
  return crc;
}

template <class Sink>
class RecordWriter {
 public:
  explicit RecordWriter(Sink& sink) : sink_(sink) {}

  void put(uint8_t byte) {
    flush();
    putRaw(byte);
  }
  void putBit(bool bit) {
    if (bit) bits_ = static_cast<uint8_t>(bits_ | 1 << used_);
    if (++used_ == 8) flush();
  }
  void finish() {
    flush();
    const uint16_t crc = crc_;
    putRaw(static_cast<uint8_t>(crc >> 8));
    putRaw(static_cast<uint8_t>(crc));
  }

 private:
  void flush() {
    if (used_ == 0) return;
    used_ = 0;
    putRaw(bits_);
    bits_ = 0;
  }
  void putRaw(uint8_t byte) {
    crc_ = crc16(crc_, byte);
    sink_.put(byte);
  }

  Sink& sink_;
  uint16_t crc_ = 0xFFFF;
  uint8_t bits_ = 0, used_ = 0;
};

template <class Source>
class RecordReader {
 public:
  explicit RecordReader(Source& source) : source_(source) {}

  uint8_t get() {
    left_ = 0;
    return getRaw();
  }
  bool getBit() {
    if (left_ == 0) {
      bits_ = getRaw();
      left_ = 8;
    }
    --left_;
    const bool bit = (bits_ & 1) != 0;
    bits_ = static_cast<uint8_t>(bits_ >> 1);
    return bit;
  }
  /// Reads the checksum and returns whether it matches the record.
  bool finish() {
    getRaw();
    getRaw();
    return crc_ == 0;
  }

 private:
  uint8_t getRaw() {
    const uint8_t byte = source_.get();
    crc_ = crc16(crc_, byte);
    return byte;
  }

  Source& source_;
  uint16_t crc_ = 0xFFFF;
  uint8_t bits_ = 0, left_ = 0;
};

}  // namespace nav

#endif
