// Functions that stand for single instructions.
#pragma once

#include <avr/io.h>

#ifndef _NOP
#define _NOP() robosim_spend_cycles(1)
#endif
#define _MemoryBarrier() __asm__ volatile("" ::: "memory")
