// Writes to its own flash.
#include <avr/boot.h>

void burn() { boot_page_erase(0x7000); }

void setup() {
  delay(20);
  burn();
}

void loop() {}
