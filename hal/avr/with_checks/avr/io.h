// With checks a sketch runs on a chip with more memory: its stack begins at __stack (sim/build/target.cpp).
// Who reckons with where RAM ends must know that.
#include_next <avr/io.h>
#undef RAMEND
#define RAMEND 0xF8FF
