// Functions that stand for single instructions.
#pragma once

#include "hal/host/registers.h"

#ifndef _NOP
#define _NOP() robosim_spend_cycles(1)
#endif
#define _MemoryBarrier() __asm__ volatile("" ::: "memory")
