// Wraps Serial for tests that cannot include Arduino.h.
#include <Arduino.h>

extern "C" {

void serial_begin(unsigned long baud) { Serial.begin(baud); }
void serial_write(const uint8_t* bytes, size_t size) { Serial.write(bytes, size); }
void serial_flush() { Serial.flush(); }
int serial_available() { return Serial.available(); }
int serial_peek() { return Serial.peek(); }
int serial_read() { return Serial.read(); }
}
