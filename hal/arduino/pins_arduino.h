// Defines a board's pins on the host. The build (sim/build/compile.cpp) passes the pins' numbers and
// functions as macros; they come from hal/board/board_spec.h. Ports and timers are those of an Uno, whose
// registers cover pins 0 to 19.
#pragma once
#ifndef Pins_Arduino_h
#define Pins_Arduino_h

#include <avr/io.h>

#define NUM_DIGITAL_PINS ROBOSIM_DIGITAL_PINS
#define NUM_ANALOG_INPUTS ROBOSIM_ANALOG_INPUTS
#define analogInputToDigitalPin(p) ((p) < NUM_ANALOG_INPUTS ? (p) + PIN_A0 : -1)
#define EXTERNAL_NUM_INTERRUPTS 2

#define LED_BUILTIN ROBOSIM_LED_BUILTIN

#define PIN_A0 (ROBOSIM_ANALOG_PIN_0)
#define PIN_A1 (PIN_A0 + 1)
#define PIN_A2 (PIN_A0 + 2)
#define PIN_A3 (PIN_A0 + 3)
#define PIN_A4 (PIN_A0 + 4)
#define PIN_A5 (PIN_A0 + 5)
#define PIN_A6 (PIN_A0 + 6)
#define PIN_A7 (PIN_A0 + 7)
static const uint8_t A0 = PIN_A0;
static const uint8_t A1 = PIN_A1;
static const uint8_t A2 = PIN_A2;
static const uint8_t A3 = PIN_A3;
static const uint8_t A4 = PIN_A4;
static const uint8_t A5 = PIN_A5;
static const uint8_t A6 = PIN_A6;
static const uint8_t A7 = PIN_A7;
#if ROBOSIM_ANALOG_INPUTS > 8
#define PIN_A8 (PIN_A0 + 8)
#define PIN_A9 (PIN_A0 + 9)
#define PIN_A10 (PIN_A0 + 10)
#define PIN_A11 (PIN_A0 + 11)
static const uint8_t A8 = PIN_A8;
static const uint8_t A9 = PIN_A9;
static const uint8_t A10 = PIN_A10;
static const uint8_t A11 = PIN_A11;
#endif
#if ROBOSIM_ANALOG_INPUTS > 12
#define PIN_A12 (PIN_A0 + 12)
#define PIN_A13 (PIN_A0 + 13)
#define PIN_A14 (PIN_A0 + 14)
#define PIN_A15 (PIN_A0 + 15)
static const uint8_t A12 = PIN_A12;
static const uint8_t A13 = PIN_A13;
static const uint8_t A14 = PIN_A14;
static const uint8_t A15 = PIN_A15;
#endif

#define PIN_SPI_SS (ROBOSIM_PIN_SS)
#define PIN_SPI_MOSI (ROBOSIM_PIN_MOSI)
#define PIN_SPI_MISO (ROBOSIM_PIN_MISO)
#define PIN_SPI_SCK (ROBOSIM_PIN_SCK)
static const uint8_t SS = PIN_SPI_SS;
static const uint8_t MOSI = PIN_SPI_MOSI;
static const uint8_t MISO = PIN_SPI_MISO;
static const uint8_t SCK = PIN_SPI_SCK;

#define PIN_WIRE_SDA (ROBOSIM_PIN_SDA)
#define PIN_WIRE_SCL (ROBOSIM_PIN_SCL)
static const uint8_t SDA = PIN_WIRE_SDA;
static const uint8_t SCL = PIN_WIRE_SCL;

#ifdef ROBOSIM_PIN_NAMES
#include ROBOSIM_PIN_NAMES
#endif

#define SERIAL_PORT_MONITOR Serial
#define SERIAL_PORT_HARDWARE Serial

#define digitalPinHasPWM(p) ROBOSIM_HAS_PWM(p)
#ifdef ROBOSIM_EVERY_PIN_INTERRUPTS
#define digitalPinToInterrupt(p) \
  ((p) == 2 ? 0 : ((p) == 3 ? 1 : ((p) >= 4 && (p) < NUM_DIGITAL_PINS ? (p) : NOT_AN_INTERRUPT)))
#else
#define digitalPinToInterrupt(p) ROBOSIM_INTERRUPT_OF(p)
#endif

// Ports are numbered as in the AVR core: B = 2, C = 3, D = 4. Pins 0..7 belong to port D, pins 8..13 to port
// B, and pins 14..19 to port C.
#define digitalPinToPort(p) ((p) < 8 ? 4 : ((p) < 14 ? 2 : ((p) < 20 ? 3 : NOT_A_PORT)))
#define digitalPinToBitMask(p) (_BV((p) < 8 ? (p) : ((p) < 14 ? (p)-8 : (p)-14)))
#define analogInPinToBit(p) (p)

#define NOT_ON_TIMER 0
#define TIMER0A 1
#define TIMER0B 2
#define TIMER1A 3
#define TIMER1B 4
#define TIMER2A 7
#define TIMER2B 8
#define digitalPinToTimer(p) \
  ((p) == 3    ? TIMER2B     \
   : (p) == 5  ? TIMER0B     \
   : (p) == 6  ? TIMER0A     \
   : (p) == 9  ? TIMER1A     \
   : (p) == 10 ? TIMER1B     \
   : (p) == 11 ? TIMER2A     \
               : NOT_ON_TIMER)

// A port's PIN, DDR and PORT registers are adjacent: PINB is 0x23, PINC 0x26, PIND 0x29.
#define portInputRegister(port) (&_SFR_MEM8(0x23 + 3 * ((port)-2)))
#define portModeRegister(port) (&_SFR_MEM8(0x24 + 3 * ((port)-2)))
#define portOutputRegister(port) (&_SFR_MEM8(0x25 + 3 * ((port)-2)))
#if defined(__cplusplus) && !defined(ROBOSIM_REGISTER_MEMORY)
#define digitalPinToPCICR(p) ((p) <= 21 ? &PCICR : robosim_hal::RegisterPointer())
#else
#define digitalPinToPCICR(p) ((p) <= 21 ? &PCICR : (volatile uint8_t*)0)
#endif
#define digitalPinToPCMSK(p) ((p) <= 7 ? &PCMSK2 : (p) <= 13 ? &PCMSK0 : &PCMSK1)
#define digitalPinToPCICRbit(p) ((p) <= 7 ? 2 : ((p) <= 13 ? 0 : 1))
#define digitalPinToPCMSKbit(p) ((p) <= 7 ? (p) : ((p) <= 13 ? (p)-8 : (p)-14))

#endif  // Pins_Arduino_h
