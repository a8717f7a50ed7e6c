// Stores three settings and a checksum in EEPROM. The checksum detects an incomplete record or a worn byte.
#ifndef SETTINGS_H
#define SETTINGS_H

#include <EEPROM.h>
#include <nav/Record.h>

struct Settings {
  uint8_t speed = 140, gain = 80;
  uint32_t odometer_mm = 0;
};

const int SETTINGS_AT = 16;
const uint8_t SETTINGS_VERSION = 1;

struct EepromBytes {
  int at = SETTINGS_AT;
  void put(uint8_t byte) { EEPROM.update(at++, byte); }
  uint8_t get() { return EEPROM.read(at++); }
};

inline void storeSettings(const Settings& settings) {
  EepromBytes bytes;
  nav::RecordWriter<EepromBytes> record(bytes);
  record.put(SETTINGS_VERSION);
  record.put(settings.speed);
  record.put(settings.gain);
  for (uint8_t shift = 0; shift < 32; shift += 8)
    record.put(static_cast<uint8_t>(settings.odometer_mm >> shift));
  record.finish();
}

/// Returns false, and changes nothing, if there is no valid record.
inline bool loadSettings(Settings& settings) {
  EepromBytes bytes;
  nav::RecordReader<EepromBytes> record(bytes);
  if (record.get() != SETTINGS_VERSION) return false;
  Settings stored;
  stored.speed = record.get();
  stored.gain = record.get();
  for (uint8_t shift = 0; shift < 32; shift += 8)
    stored.odometer_mm |= static_cast<uint32_t>(record.get()) << shift;
  if (!record.finish()) return false;
  settings = stored;
  return true;
}

#endif
