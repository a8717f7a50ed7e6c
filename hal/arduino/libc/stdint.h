// Fixed-width integers, as gcc defines them for the target.
#pragma once
#if __has_include(<stdint-gcc.h>)
#include <stdint-gcc.h>
#else
#include_next <stdint.h>
#endif
