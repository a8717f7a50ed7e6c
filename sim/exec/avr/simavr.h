// The emulator: libsimavr 1.6 (GPL-3). Only this folder includes it, and only the program robosim-avr links
// it; that program is therefore under the GPL-3 as a whole, while its source here, as all of Robosim's, is
// under the MIT licence.
#pragma once

extern "C" {
#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_flash.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>
#include <simavr/avr_uart.h>
#include <simavr/avr_watchdog.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
}
