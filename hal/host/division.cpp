// On 32-bit ARM, replaces the division functions of the compiler's library. A division by zero then has the
// chip's result. sim/build/division.h has the table of results, and handles division instructions.
#if defined(__arm__)

#ifdef ROBOSIM_ZERO_BY_ZERO
#define ROBOSIM_ONES(to) "mov " to ", #0\n"
#define ROBOSIM_ONES_OR_ONE(to, sign) "mov " to ", #0\n"
#define ROBOSIM_HIGH_OF_ONES_OR_ONE(to, sign) "mov " to ", #0\n"
#else
#define ROBOSIM_ONES(to) "mvn " to ", #0\n"
#define ROBOSIM_ONES_OR_ONE(to, sign) "mvn " to ", " sign ", lsl #1\n"
#define ROBOSIM_HIGH_OF_ONES_OR_ONE(to, sign) "mvn " to ", " sign "\n"
#endif

// Defines a function to which the linker redirects calls of a library function (--wrap,
// sim/build/target.cpp).
#define ROBOSIM_BEFORE(function, look_at_divisor, by_zero)                         \
  extern "C" __attribute__((naked)) void __wrap_##function() {                     \
    asm(look_at_divisor "\nbeq 1f\nb __real_" #function "\n1:\n" by_zero "bx lr"); \
  }

// The functions return the quotient in r0 and the remainder in r1. With 64 bits, they return the quotient in
// r0 and r1, and the remainder in r2 and r3.
ROBOSIM_BEFORE(__aeabi_idiv, "cmp r1, #0", "asr r0, r0, #31\n" ROBOSIM_ONES_OR_ONE("r0", "r0"))
ROBOSIM_BEFORE(__aeabi_idivmod, "cmp r1, #0", "mov r1, r0\nasr r0, r0, #31\n" ROBOSIM_ONES_OR_ONE("r0", "r0"))
ROBOSIM_BEFORE(__aeabi_uidiv, "cmp r1, #0", ROBOSIM_ONES("r0"))
ROBOSIM_BEFORE(__aeabi_uidivmod, "cmp r1, #0", "mov r1, r0\n" ROBOSIM_ONES("r0"))
ROBOSIM_BEFORE(__aeabi_ldivmod, "orrs ip, r2, r3",
               "mov r2, r0\nmov r3, r1\nasr r1, r1, #31\n" ROBOSIM_ONES_OR_ONE("r0", "r1")
                   ROBOSIM_HIGH_OF_ONES_OR_ONE("r1", "r1"))
ROBOSIM_BEFORE(__aeabi_uldivmod, "orrs ip, r2, r3",
               "mov r2, r0\nmov r3, r1\n" ROBOSIM_ONES("r0") ROBOSIM_ONES("r1"))

#endif
