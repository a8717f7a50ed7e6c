// With checks a sketch runs on a chip with more memory, and its stack begins at __stack
// (sim/build/target.cpp). Code that uses the end of RAM needs that address.
#include_next <avr/io.h>
#undef RAMEND
#define RAMEND 0xF8FF
