// Numbers the pins of the Blue Pill. Numbers 0 to 19 have the functions of an Uno's pins 0 to 19. The
// remaining pins follow.
#pragma once
#ifndef Pins_Arduino_h
#define Pins_Arduino_h

#include <stdint.h>

#define NUM_DIGITAL_PINS 32
#define NUM_ANALOG_INPUTS 8
#define analogInputToDigitalPin(p) ((p) < 8 ? (p) + 14 : -1)
#define EXTERNAL_NUM_INTERRUPTS 16

#define LED_BUILTIN 13  // PC13; the LED is lit while the pin is LOW

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

#include "bluepill.h"

#define SERIAL_PORT_MONITOR Serial
#define SERIAL_PORT_HARDWARE Serial

#define digitalPinHasPWM(p)                                                                            \
  ((p) == 0 || (p) == 1 || (p) == 3 || (p) == 5 || (p) == 6 || ((p) >= 9 && (p) <= 12) || (p) == 20 || \
   (p) == 21 || (p) == 28)
/// Every pin can have an interrupt. Pins with the same number in different ports, such as PA8 and PB8, cannot
/// have interrupts at the same time.
#define digitalPinToInterrupt(p) ((p) < NUM_DIGITAL_PINS ? (p) : NOT_AN_INTERRUPT)

#endif  // Pins_Arduino_h
