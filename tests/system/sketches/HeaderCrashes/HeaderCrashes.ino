// The fault is in a header of the library that lies beside it.
#include <Brittle.h>

void setup() { brittle(nullptr); }

void loop() {}
