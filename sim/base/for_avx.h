// A function that is mostly arithmetic, compiled twice on x86-64: once for processors with AVX, which is
// chosen when the program is loaded. There an instruction names the register for its result, so that no
// operand is copied first: a sixth of them go away. The bits stay as they are, since no multiplication is
// fused with an addition.
#pragma once

#include <cstdint>  // __GLIBC__

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GLIBC__) && defined(__GNUC__) && \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
/// In front of such a function's definition, which stands in a .cpp file.
#define ROBOSIM_FOR_AVX_TOO [[gnu::target_clones("avx", "default")]]
#else
#define ROBOSIM_FOR_AVX_TOO
#endif
