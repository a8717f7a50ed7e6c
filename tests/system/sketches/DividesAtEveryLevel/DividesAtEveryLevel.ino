// Divides numbers of 8, 16, 32 and 64 bits, signed or not, at -O0, -Os and -O2: by zero, by -1, and normally.
#include "Divisions.h"

void setup() {
  Serial.begin(115200);
  at_O0::all_types();
  at_Os::all_types();
  at_O2::all_types();
}

void loop() {}
