#include "Blinker.h"

int blinks;
