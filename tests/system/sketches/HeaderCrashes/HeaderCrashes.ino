// The fault is in a header of the library next to this sketch.
#include <Brittle.h>

void setup() { brittle(nullptr); }

void loop() {}
