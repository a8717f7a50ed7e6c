// Defines alloca(), as in avr-libc.
#pragma once
#define alloca(size) __builtin_alloca(size)
