// Compiles an arithmetic function twice on x86-64: once for processors with AVX or AVX2, chosen when the
// program is loaded. AVX instructions have a separate result register, which saves a sixth of the
// instructions, and AVX2 processes four numbers at once.
//
// The bits stay the same, as the same additions and multiplications are made. Fusing two into one instruction
// would change them; hence -ffp-contract=off, and no FMA.
#pragma once

/// Precedes such a function's definition in a .cpp file: ROBOSIM_ALSO_FOR("avx").
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROBOSIM_ALSO_FOR(processors) [[gnu::target_clones(processors, "default")]]
#else
#define ROBOSIM_ALSO_FOR(processors)
#endif
