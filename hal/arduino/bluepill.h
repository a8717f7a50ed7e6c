// Declares names that sketches for a Blue Pill use, but that the core of an Uno does not have. These are
// STM32duino's names of the chip's pins, and functions for the resolution of analog values. The targets host
// and stm32 include this header. PA13, PA14 and PB2 are missing: the debugger uses PA13 and PA14, and PB2 is
// BOOT1.
#pragma once

#include <stdint.h>

// On the host <avr/io.h> defines bit numbers with these names.
#undef PB0
#undef PB1
#undef PB2
#undef PB3
#undef PB4
#undef PB5
#undef PB6
#undef PB7

#define PA0 14
#define PA1 15
#define PA2 16
#define PA3 17
#define PA4 18
#define PA5 19
#define PA6 12
#define PA7 11
#define PA8 3
#define PA9 1
#define PA10 0
#define PA11 28
#define PA12 29
#define PA15 25
#define PB0 20
#define PB1 21
#define PB3 26
#define PB4 27
#define PB5 22
#define PB6 5
#define PB7 6
#define PB8 9
#define PB9 10
#define PB10 23
#define PB11 24
#define PB12 2
#define PB13 4
#define PB14 7
#define PB15 8
#define PC13 13
#define PC14 30
#define PC15 31

#ifdef __cplusplus
extern "C" {
#endif

/// Makes analogRead return values from 0 to 2^bits - 1. `bits` is 1 to 16; the default is 10. The STM32F103's
/// converter has 12 bits, and the host's has 10. If `bits` is larger, a result's lowest bits are zero.
void analogReadResolution(int bits);
/// Makes analogWrite accept values from 0 to 2^bits - 1. `bits` is 1 to 16; the default is 8. The resolution
/// of PWM itself stays at 8 bits.
void analogWriteResolution(int bits);

#ifdef __cplusplus
}  // extern "C"
#endif
