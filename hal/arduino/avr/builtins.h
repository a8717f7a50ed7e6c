// Replaces those built-in functions of avr-gcc that have a meaning on the host.
#pragma once

#include "hal/host/registers.h"

#define __builtin_avr_sei() robosim_enable_interrupts()
#define __builtin_avr_cli() robosim_disable_interrupts()
#define __builtin_avr_sleep() robosim_sleep()
#define __builtin_avr_wdr() robosim_watchdog_reset()
#define __builtin_avr_delay_cycles(cycles) robosim_spend_cycles(cycles)
