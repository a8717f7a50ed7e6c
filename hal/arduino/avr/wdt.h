// The watchdog timer: its register and the WDR instruction.
#pragma once

#include <avr/io.h>

#define WDTO_15MS 0
#define WDTO_30MS 1
#define WDTO_60MS 2
#define WDTO_120MS 3
#define WDTO_250MS 4
#define WDTO_500MS 5
#define WDTO_1S 6
#define WDTO_2S 7
#define WDTO_4S 8
#define WDTO_8S 9

// WDTCSR: WDE is bit 3, WDCE bit 4; the prescaler's bits are 0..2 and 5.
#define wdt_enable(timeout) \
  (robosim_watchdog_reset(), WDTCSR = 0x18, WDTCSR = (0x08 | ((timeout)&7) | (((timeout)&8) << 2)))
#define wdt_disable() (robosim_watchdog_reset(), WDTCSR = 0x18, WDTCSR = 0)
#define wdt_reset() robosim_watchdog_reset()
