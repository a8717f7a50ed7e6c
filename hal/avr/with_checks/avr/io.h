// Replaces RAMEND in sketches that are built with checks (--sanitize). Such sketches run on a chip with more
// memory, and their stack begins at __stack (sim/build/target.cpp). Here, RAMEND equals __stack, for code
// that uses the end of RAM.
#include_next <avr/io.h>
#undef RAMEND
#define RAMEND 0xF8FF
