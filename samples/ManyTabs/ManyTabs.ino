#include "config.h"

// Follows a line with three digital sensors. The tabs: ManyTabs, a_sensors, b_motors, z_menu, and config.h

Mode mode = MODE_SLOW;          // Mode is in config.h
Reading now;

void setup() {
  Serial.begin(BAUD);
  motorsBegin();
  sensorsBegin();
  printMenu();
}

void loop() {
  menu();
  now = look();
  if (now.black == 0) {
    steer(now.lastSeen * 1.4, mode);
  } else {
    steer(now.position, mode);
  }
}
