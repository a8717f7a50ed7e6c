// Macros for programs that examine the effect of a write cycle by cycle. Each macro emits a write, a number
// of NOPs and a read.
//
//   OUT_IN    the read comes nops + 1 cycles after the write; for the first 64 I/O registers only
//   STS_LDS   the read comes nops + 2 cycles after the write
//
// host.h has these macros for the target host.
#pragma once

#include "report.h"

#ifndef ROBOSIM

#define OUT_IN(to, value, nops, from)                                                                     \
  ({                                                                                                      \
    uint8_t found_;                                                                                       \
    __asm__ volatile("out %1, %2\n\t.rept %3\n\tnop\n\t.endr\n\tin %0, %4"                                \
                     : "=r"(found_)                                                                       \
                     : "I"(_SFR_IO_ADDR(to)), "r"((uint8_t)(value)), "n"(nops), "I"(_SFR_IO_ADDR(from))); \
    found_;                                                                                               \
  })
#define STS_LDS(to, value, nops, from)                                                                      \
  ({                                                                                                        \
    uint8_t found_;                                                                                         \
    __asm__ volatile("sts %1, %2\n\t.rept %3\n\tnop\n\t.endr\n\tlds %0, %4"                                 \
                     : "=r"(found_)                                                                         \
                     : "n"(_SFR_MEM_ADDR(to)), "r"((uint8_t)(value)), "n"(nops), "n"(_SFR_MEM_ADDR(from))); \
    found_;                                                                                                 \
  })
/// Executes two OUTs in two cycles, then an IN nops + 1 cycles after the second OUT.
#define OUT_OUT_IN(first, value1, second, value2, nops, from)                                       \
  ({                                                                                                \
    uint8_t found_;                                                                                 \
    __asm__ volatile("out %1, %2\n\tout %3, %4\n\t.rept %5\n\tnop\n\t.endr\n\tin %0, %6"            \
                     : "=r"(found_)                                                                 \
                     : "I"(_SFR_IO_ADDR(first)), "r"((uint8_t)(value1)), "I"(_SFR_IO_ADDR(second)), \
                       "r"((uint8_t)(value2)), "n"(nops), "I"(_SFR_IO_ADDR(from)));                 \
    found_;                                                                                         \
  })

#endif
