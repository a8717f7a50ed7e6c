// Provides _delay_loop_1() and _delay_loop_2(), which <util/delay.h> defines here.
#pragma once
#include <util/delay.h>
