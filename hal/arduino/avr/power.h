// Switches modules of the chip on and off (bits of PRR), and sets the clock divisor (CLKPR). On the host, a
// module that is switched off continues to work, and the clock does not change. If a run on the
// chip then differs, `robosim compare` names the register.
#pragma once

#include <avr/io.h>

#define power_adc_enable() (PRR &= ~_BV(PRADC))
#define power_adc_disable() (PRR |= _BV(PRADC))
#define power_spi_enable() (PRR &= ~_BV(PRSPI))
#define power_spi_disable() (PRR |= _BV(PRSPI))
#define power_twi_enable() (PRR &= ~_BV(PRTWI))
#define power_twi_disable() (PRR |= _BV(PRTWI))
#define power_usart0_enable() (PRR &= ~_BV(PRUSART0))
#define power_usart0_disable() (PRR |= _BV(PRUSART0))
#define power_timer0_enable() (PRR &= ~_BV(PRTIM0))
#define power_timer0_disable() (PRR |= _BV(PRTIM0))
#define power_timer1_enable() (PRR &= ~_BV(PRTIM1))
#define power_timer1_disable() (PRR |= _BV(PRTIM1))
#define power_timer2_enable() (PRR &= ~_BV(PRTIM2))
#define power_timer2_disable() (PRR |= _BV(PRTIM2))
typedef enum {
  clock_div_1,
  clock_div_2,
  clock_div_4,
  clock_div_8,
  clock_div_16,
  clock_div_32,
  clock_div_64,
  clock_div_128,
  clock_div_256
} clock_div_t;
#define clock_prescale_set(divisor) (CLKPR = _BV(CLKPCE), CLKPR = (divisor))
#define clock_prescale_get() ((clock_div_t)(CLKPR & 0x0F))

#define power_all_enable() (PRR = 0)
#define power_all_disable() (PRR = 0xEF)
