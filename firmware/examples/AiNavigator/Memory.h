// What is kept in EEPROM: the map, which has a version and a checksum of its own, and at the end the node at
// which the robot stands, while it does stand.
#ifndef MEMORY_H
#define MEMORY_H

#include <EEPROM.h>
#include <stdint.h>

/// The map's bytes, for save() and load() of the network.
struct EepromRecord {
  int at = 0;
  void put(uint8_t byte) { EEPROM.update(at++, byte); }
  uint8_t get() { return EEPROM.read(at++); }
};

/// Where the robot stands.
struct Stand {
  uint8_t node, heading;
};

const int STAND_AT = 1021;  // node, heading, and a byte by which a damaged one is noticed

inline uint8_t checkOf(const Stand& stand) {
  return static_cast<uint8_t>(0x5A ^ stand.node ^ (stand.heading << 4));
}

inline void storeStand(uint8_t node, uint8_t heading) {
  const Stand stand = {node, heading};
  EEPROM.update(STAND_AT, node);
  EEPROM.update(STAND_AT + 1, heading);
  EEPROM.update(STAND_AT + 2, checkOf(stand));
}

inline bool loadStand(Stand& stand) {
  stand.node = EEPROM.read(STAND_AT);
  stand.heading = EEPROM.read(STAND_AT + 1);
  return stand.heading < 4 && EEPROM.read(STAND_AT + 2) == checkOf(stand);
}

/// It is under way, or lost.
inline void forgetStand() { EEPROM.update(STAND_AT + 1, 255); }

/// Nothing was ever stored.
inline bool isBlank() { return EEPROM.read(0) == 255 && EEPROM.read(1) == 255; }

#endif
