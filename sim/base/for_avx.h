// A function that is mostly arithmetic, compiled twice on x86-64: once for processors with AVX or AVX2, which
// is chosen when the program is loaded. There an instruction names the register for its result, so that no
// operand is copied first, which is a sixth of them; and AVX2 works on four numbers at once. The bits stay as
// they are: the same additions and multiplications are made. (Fusing two into one instruction would change
// them; hence -ffp-contract=off, and no FMA.)
#pragma once

/// In front of such a function's definition in a .cpp file: ROBOSIM_ALSO_FOR("avx").
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROBOSIM_ALSO_FOR(processors) [[gnu::target_clones(processors, "default")]]
#else
#define ROBOSIM_ALSO_FOR(processors)
#endif
