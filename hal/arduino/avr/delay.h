// The former name of <util/delay.h> in avr-libc.
#pragma once
#include <util/delay.h>
