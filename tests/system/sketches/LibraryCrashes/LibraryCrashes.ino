// The fault is in the library next to this sketch.
#include <Fragile.h>

void setup() { fragile(nullptr); }

void loop() {}
