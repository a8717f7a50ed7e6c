// Provides size_t and the fixed-width integers, as avr-libc's <sys/types.h> does.
#pragma once
#include <stddef.h>
#include <stdint.h>
