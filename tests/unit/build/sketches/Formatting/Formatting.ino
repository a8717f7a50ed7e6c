// Formats numbers in ways in which avr-libc differs from a PC's library.
#include <math.h>
#include <stdio.h>
#include <string.h>

char text[40];

void show(const char *value) { Serial.println(value); }

void setup() {
  Serial.begin(115200);
  sprintf(text, "%d %5d|%-5d|%05d %+d", 1, -2, 3, -4, 5);
  show(text);
  sprintf(text, "%x %X %#x %o %u %c%%", 255, 255, 255, 8, 7u, 'c');
  show(text);
  sprintf(text, "%ld %lu %s|%6s|%-6s|%.2s", -70000L, 70000UL, "abc", "abc", "abc", "abc");
  show(text);
  sprintf(text, "%f %6.2f", 1.5, 2.5);
  show(text);
  Serial.println(snprintf(text, 5, "%d", 1234567));
  show(text);
  show(itoa(-42, text, 10));
  show(itoa(255, text, 2));
  show(ultoa(4000000000UL, text, 16));
  show(dtostrf(3.14159, 8, 2, text));
  show(dtostrf(-3.14159, -8, 3, text));
  show(dtostre(12345.678, text, 3, DTOSTR_ALWAYS_SIGN));
  strlcpy(text, "0123456789", 5);
  strlcat(text, "ab", 6);
  show(text);
  show(strupr(strrev(text)));
  printf("nowhere %d\n", 3);
  Serial.println(sq(3) + round(2.5) + (int)abs(-1.5) + (int)degrees(PI) + lround(0.6));
  Serial.println(isnan(NAN));
}

void loop() {}
