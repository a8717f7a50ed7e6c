// Describes chips as data, for emulators, the host's model of a chip, the build, and programmers.
//
//   ChipSpec   one per chip, in a header of its own, from its data sheet: atmega328p.h, stm32f103c8.h
//   BoardSpec  one per board: its chip, its clock, and the names of its pins (board_spec.h)
//
// All ChipSpecs and BoardSpecs are constants, so array sizes and case labels can use them. This header uses
// C++14 without the standard library, because firmware images include it, too.
#pragma once

#include <stdint.h>

namespace robosim {

/// A pin of a chip. A number is -1 if the pin does not have the function.
struct ChipPin {
  const char* name;       ///< the data sheet's name: "PD5"
  int8_t port;            ///< index of ChipSpec::ports; -1 = analog input only
  uint8_t bit;            ///< bit in the port's registers
  int8_t analog_channel;  ///< channel of the ADC
  int8_t timer;           ///< index in ChipSpec::timers of the timer that can drive the pin by PWM
  uint8_t output;         ///< output of that timer, from 0
  int8_t external;        ///< n of INTn; the EXTI line of an STM32
  int8_t change;          ///< n of PCINTn
  int8_t counted_by;      ///< index of the timer that can count the pin's edges (Tn)
  int8_t captured_by;     ///< index of the timer that can capture the time of the pin's edges (ICPn)
};

struct PortSpec {
  char letter;
  uint32_t address;  ///< address of PINx, followed by DDRx and PORTx; on an STM32, of GPIOx_CRL
};

struct TimerSpec {
  uint8_t number;          ///< the n in the names of its registers
  uint8_t bits;            ///< width of the counter
  uint32_t control;        ///< address of TCCRnA; on an STM32, of TIMn_CR1, the first of its registers
  uint16_t count;          ///< address of TCNTn
  uint16_t compare[3];     ///< addresses of OCRnA, OCRnB and OCRnC; 0 = none
  uint16_t capture;        ///< address of ICRn; 0 = none
  uint16_t enables;        ///< address of TIMSKn
  uint16_t prescalers[8];  ///< indexed by the bits CSn2 to CSn0; 0 = stopped or external clock
  uint8_t vector;          ///< vector of compare A, then of B, C and overflow; on an STM32, of update
  // AVR only:
  uint16_t flags = 0;          ///< address of TIFRn
  bool own_prescaler = false;  ///< false if the timer shares its prescaler with other timers
  uint16_t reduction = 0;      ///< address of PRR
  int8_t reduction_bit = -1;   ///< the bit of PRR that stops the timer
  // Registers; the defaults are an ATmega's:
  uint16_t control_b = 0;       ///< address of TCCRnB; 0 = the address after TCCRnA
  uint16_t top = 0;             ///< address of an ATtiny85's OCR1C (`control` is then TCCR1); 0 = none
  const char* pins[2] = {};     ///< the pins OCnA and OCnB, if ChipSpec::pins lists them for another timer
  uint8_t overflow_vector = 0;  ///< vector of overflow; 0 = after the vectors of the matches
  uint8_t match_b_vector = 0;   ///< vector of compare B; 0 = after the vector of compare A
  uint8_t flag_bits[3] = {0, 1, 2};  ///< bits of overflow, compare A and B in TIFR and TIMSK
};

/// The value of TimerSpec::bits that identifies the ATmega32U4's high-speed timer 4.
constexpr uint8_t kHighSpeedBits = 10;

/// Returns whether the timer shares TIFR and TIMSK with other timers.
constexpr bool shares_flags(const TimerSpec& timer) { return timer.flag_bits[0] != 0; }

/// Returns the number of the timer's OCRnx registers.
constexpr uint8_t channels(const TimerSpec& timer) { return timer.compare[2] ? 3 : 2; }

struct UartSpec {
  uint8_t number;    ///< the n in the names of its registers
  uint32_t address;  ///< address of UCSRnA, followed by UCSRnB and UCSRnC; on an STM32, of USARTn_SR
  uint16_t divider;  ///< address of UBRRn
  uint16_t data;     ///< address of UDRn
  uint8_t vector;    ///< vector of a received byte; on an AVR, `data register empty` and `sent` follow
  const char* rx;    ///< names of the pins
  const char* tx;
  uint16_t reduction = 0;     ///< address of PRR
  int8_t reduction_bit = -1;  ///< the bit of PRR that stops the USART
};

struct AdcSpec {
  uint8_t bits;            ///< number of bits of a result
  uint8_t pins;            ///< channels 0 to pins - 1 are pins
  double bandgap_volts;    ///< voltage of the internal reference; 0 = none
  int8_t bandgap_channel;  ///< the bits MUX that select the bandgap; -1 = none
  uint8_t vector;
  // AVR only:
  /// The vector of the flag that starts a conversion, indexed by the bits ADTS; 0 = the ADC's own flag.
  uint8_t triggers[8] = {};
  uint16_t reduction = 0;           ///< address of PRR
  int8_t reduction_bit = -1;        ///< the bit of PRR that stops the ADC
  double references[8] = {};        ///< in volts, indexed by REFS2, REFS1 and REFS0; 0 = the supply
  uint8_t reference_bit = 0;        ///< REFS2 in ADMUX; 0 = none
  uint8_t multiplexer_bits = 0x0F;  ///< MUX in ADMUX
  uint8_t high_channels = 0;        ///< MUX5 in ADCSRB, which selects channels from 8 on; 0 = none
  uint8_t control_b_bits = 0x47;    ///< the implemented bits of ADCSRB
};

struct SpiSpec {
  uint16_t address = 0;  ///< address of an AVR's SPCR, followed by SPSR and SPDR; 0 = not described
  uint8_t vector = 0;
  const char* select = "";  ///< names of the pins SS, MOSI, MISO and SCK
  const char* out = "";
  const char* in = "";
  const char* clock = "";
  uint16_t reduction = 0;
  int8_t reduction_bit = -1;
};

struct TwiSpec {
  uint16_t address = 0;  ///< address of an AVR's TWBR; TWSR, TWAR, TWDR and TWCR follow; 0 = not described
  uint8_t vector = 0;
  const char* data = "";  ///< names of the pins SDA and SCL
  const char* clock = "";
  uint16_t reduction = 0;
  int8_t reduction_bit = -1;
};

struct ComparatorSpec {
  uint16_t address = 0;  ///< address of an AVR's ACSR; 0 = not described
  uint8_t vector = 0;
  const char* positive = "";  ///< names of the pins AIN0 and AIN1; without AIN1, the input is the bandgap
  const char* negative = "";
  uint8_t channels = 0;     ///< the number of ADC channels, from 0 on, that may replace AIN1; a power of two
  int8_t captured_by = -1;  ///< index of the timer that can capture changes of the output
};

/// Addresses in data memory of an AVR's other registers; the defaults are an ATmega's.
struct AvrRegisters {
  uint16_t external_sense = 0x69;                ///< EICRA, with ISC0 in its lowest bits
  uint16_t external_enables = 0x3D;              ///< EIMSK
  uint16_t external_flags = 0x3C;                ///< EIFR
  uint8_t external_bit = 0;                      ///< number of INT0's bit in EIMSK and EIFR
  uint16_t change_enables = 0x68;                ///< PCICR
  uint16_t change_flags = 0x3B;                  ///< PCIFR
  uint8_t change_bit = 0;                        ///< number of the first group's bit in PCICR and PCIFR
  uint16_t change_masks = 0x6B;                  ///< PCMSK0, followed by the other PCMSKn
  uint8_t pull_ups_off = 0x10;                   ///< PUD in MCUCR
  uint16_t sleep = 0x53;                         ///< SMCR
  uint8_t sleep_enable = 0x01;                   ///< SE in SMCR
  uint8_t sleep_modes = 0x0E;                    ///< SM in SMCR
  uint16_t clock_divisor = 0x61;                 ///< CLKPR
  uint16_t watchdog = 0x60;                      ///< WDTCSR
  uint16_t timers = 0x43;                        ///< GTCCR
  uint8_t timers_kept = 0;                       ///< bits in GTCCR that control only timer 1
  uint16_t pll = 0;                              ///< PLLCSR of a PLL that clocks a timer; 0 = none
  uint16_t eeprom = 0x3F;                        ///< EECR, followed by EEDR, EEARL and EEARH
  uint16_t adc_data = 0x78;                      ///< ADCL, followed by ADCH
  uint16_t adc_control = 0x7A;                   ///< ADCSRA
  uint16_t adc_control_b = 0x7B;                 ///< ADCSRB
  uint16_t adc_multiplexer = 0x7C;               ///< ADMUX
  uint16_t digital_off[3] = {0x7E, 0x7F, 0x7D};  ///< DIDR0 to DIDR2; equal if one register serves all pins
  uint16_t general[2] = {0x3E, 0x4A};            ///< GPIOR0, GPIOR1
};

/// A USB device controller. It is a serial line to the computer, numbered after the UARTs.
struct UsbSpec {
  uint16_t address = 0;  ///< address of an AVR's USBCON, followed by the other registers; 0 = none
  uint16_t pll = 0;      ///< address of PLLCSR
  uint8_t vector = 0;    ///< the general vector, followed by the endpoints' vector
  uint16_t reduction = 0;
  int8_t reduction_bit = -1;
};

struct ChipSpec {
  const char* name;           ///< the maker's name: "ATmega328P"
  const char* target;         ///< the target that executes the chip's firmware, as users name it: "avr"
  const char* compiler_name;  ///< avr-gcc's -mmcu; for an STM32 the name of the linker script
  const char* architecture;   ///< avr-gcc's folder of libraries for the chip: "avr5"; null = none
  const char* macro;          ///< the macro that avr-gcc defines for the chip; null = none
  const char* registers;      ///< avr-libc's header of the chip's registers; null = none
  const char* avrdude_name;   ///< null = avrdude does not support the chip
  uint8_t signature[3];       ///< the signature that programmers read; zeros = none

  uint32_t flash_address;  ///< start of flash, in a separate address space on an AVR
  uint32_t flash_bytes;    ///< including the boot loader
  uint32_t ram_address;
  uint32_t ram_bytes;
  uint16_t eeprom_bytes;         ///< 0 = the core emulates an EEPROM in flash
  uint8_t return_address_bytes;  ///< number of bytes that a call pushes; 0 = a register stores the address

  uint8_t vectors;          ///< number of interrupt vectors, including reset
  uint8_t external_vector;  ///< vector of INT0, followed by the other INTn
  uint8_t external_count;   ///< number of INTn
  uint8_t change_vector;    ///< vector of PCINT0 to 7, followed by the other groups
  uint8_t change_count;     ///< number of groups of eight PCINTn
  uint8_t watchdog_vector = 0;
  uint8_t eeprom_vector = 0;
  bool small_core = false;           ///< an AVR without MUL, JMP and CALL
  bool linked_relaxed = false;       ///< Arduino's linker shortens calls and jumps (--relax)
  uint16_t start_up_cycles = 16384;  ///< start-up time of the oscillator after power-down; default: a crystal

  const ChipPin* pins;
  uint8_t pin_count;
  const PortSpec* ports;
  uint8_t port_count;
  const TimerSpec* timers;
  uint8_t timer_count;
  const UartSpec* uarts;
  uint8_t uart_count;
  AdcSpec adc;
  SpiSpec spi = {};
  TwiSpec twi = {};
  ComparatorSpec comparator = {};
  UsbSpec usb = {};
  AvrRegisters at = {};
};

constexpr uint32_t ram_end(const ChipSpec& chip) { return chip.ram_address + chip.ram_bytes; }

}  // namespace robosim
