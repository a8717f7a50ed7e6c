// Pins of the Blue Pill: Arduino's numbers 0 to 19 where an Uno has them, then what is left; and the names
// that STM32duino uses, PA0 to PC15. PA13 and PA14 are the debugger's, PB2 is BOOT1.
#pragma once
#ifndef Pins_Arduino_h
#define Pins_Arduino_h

#include <stdint.h>

#define NUM_DIGITAL_PINS 32
#define NUM_ANALOG_INPUTS 8
#define analogInputToDigitalPin(p) ((p) < 8 ? (p) + 14 : -1)
#define EXTERNAL_NUM_INTERRUPTS 16

#define LED_BUILTIN 13  // PC13, lit while LOW

#define PIN_A0 (14)
#define PIN_A1 (15)
#define PIN_A2 (16)
#define PIN_A3 (17)
#define PIN_A4 (18)
#define PIN_A5 (19)
#define PIN_A6 (20)
#define PIN_A7 (21)
static const uint8_t A0 = PIN_A0;
static const uint8_t A1 = PIN_A1;
static const uint8_t A2 = PIN_A2;
static const uint8_t A3 = PIN_A3;
static const uint8_t A4 = PIN_A4;
static const uint8_t A5 = PIN_A5;
static const uint8_t A6 = PIN_A6;
static const uint8_t A7 = PIN_A7;

#define PA0 14
#define PA1 15
#define PA2 16
#define PA3 17
#define PA4 18
#define PA5 19
#define PA6 12
#define PA7 11
#define PA8 3
#define PA9 1
#define PA10 0
#define PA11 28
#define PA12 29
#define PA15 25
#define PB0 20
#define PB1 21
#define PB3 26
#define PB4 27
#define PB5 22
#define PB6 5
#define PB7 6
#define PB8 9
#define PB9 10
#define PB10 23
#define PB11 24
#define PB12 2
#define PB13 4
#define PB14 7
#define PB15 8
#define PC13 13
#define PC14 30
#define PC15 31

#define SERIAL_PORT_MONITOR Serial
#define SERIAL_PORT_HARDWARE Serial

#define digitalPinHasPWM(p)                                                                            \
  ((p) == 0 || (p) == 1 || (p) == 3 || (p) == 5 || (p) == 6 || ((p) >= 9 && (p) <= 12) || (p) == 20 || \
   (p) == 21 || (p) == 28)
/// Every pin interrupts; two of the same number in different ports (PB8 and PA8) cannot at the same time.
#define digitalPinToInterrupt(p) ((p) < NUM_DIGITAL_PINS ? (p) : NOT_AN_INTERRUPT)

#endif  // Pins_Arduino_h
