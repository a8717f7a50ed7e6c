// Stores the map, with version and checksum, at the start of the EEPROM. The last three bytes store the node
// at which the robot stopped, its heading, and a check byte.
#ifndef MEMORY_H
#define MEMORY_H

#include <EEPROM.h>
#include <stdint.h>

/// Reads and writes the map's bytes for the network's save() and load().
struct EepromRecord {
  int at = 0;
  void put(uint8_t byte) { EEPROM.update(at++, byte); }
  uint8_t get() { return EEPROM.read(at++); }
};

/// The stored position of the robot.
struct Stand {
  uint8_t node, heading;
};

const int STAND_AT = 1021;  // EEPROM address of the stored position: node, heading, and a check byte

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

/// Invalidates the stored position. Call it when the robot moves or is lost.
inline void forgetStand() { EEPROM.update(STAND_AT + 1, 255); }

/// Returns whether the EEPROM has never been written.
inline bool isBlank() { return EEPROM.read(0) == 255 && EEPROM.read(1) == 255; }

#endif
