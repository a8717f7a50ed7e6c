#include <Fragile.h>

void fragile(int* value) { *value = 1; }
