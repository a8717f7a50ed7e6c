// Provides the register macros of avr-libc's <avr/sfr_defs.h>, which <avr/io.h> defines here.
#pragma once
#include <avr/io.h>
