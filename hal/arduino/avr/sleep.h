// Sleep modes. On the host, the next interrupt wakes the chip in every mode, and timers continue to run.
#pragma once

#include <avr/io.h>

#define set_sleep_mode(mode) (SMCR = (SMCR & ~0x0E) | (mode))
#define sleep_enable() (SMCR |= 0x01)
#define sleep_disable() (SMCR &= ~0x01)
#define sleep_cpu() robosim_sleep()
#define sleep_bod_disable() ((void)0)
#define sleep_mode() \
  do {               \
    sleep_enable();  \
    sleep_cpu();     \
    sleep_disable(); \
  } while (0)
