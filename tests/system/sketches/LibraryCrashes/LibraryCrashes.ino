// The fault is in the library that lies beside it.
#include <Fragile.h>

void setup() { fragile(nullptr); }

void loop() {}
