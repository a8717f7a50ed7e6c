// Implements avr-libc's busy waits. Durations are rounded up to whole microseconds.
#pragma once

#include <Arduino.h>

static inline void _delay_us(double us) { delayMicroseconds((unsigned int)(us + 0.999)); }
static inline void _delay_ms(double ms) { _delay_us(ms * 1000.0); }
