// Declares functions of hal/stm32 for tests. Tests cannot include Arduino.h, whose macros and C library
// conflict with those of this machine.
#pragma once

#include <cstddef>
#include <cstdint>

#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define FALLING 2
#define RISING 3
#define LSBFIRST 0
#define MSBFIRST 1
#define digitalPinToInterrupt(p) (p)

namespace robosim::stm32 {
void start_clocks();
}

void tone(uint8_t pin, unsigned int frequency, unsigned long duration = 0);
void noTone(uint8_t pin);

extern "C" {
void init();
void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t level);
int digitalRead(uint8_t pin);
int analogRead(uint8_t pin);
void analogReadResolution(int bits);
void analogWriteResolution(int bits);
void analogWrite(uint8_t pin, int value);
unsigned long millis();
unsigned long micros();
void delay(unsigned long ms);
void delayMicroseconds(unsigned int us);
unsigned long pulseIn(uint8_t pin, uint8_t state, unsigned long timeout);
void shiftOut(uint8_t data, uint8_t clock, uint8_t order, uint8_t value);
uint8_t shiftIn(uint8_t data, uint8_t clock, uint8_t order);
void attachInterrupt(uint8_t pin, void (*handler)(), int mode);
void detachInterrupt(uint8_t pin);
void serial_begin(unsigned long baud);
void serial_write(const uint8_t* bytes, size_t size);
void serial_flush();
int serial_available();
int serial_peek();
int serial_read();
uint8_t robosim_eeprom_read(uint16_t address);
void robosim_eeprom_write(uint16_t address, uint8_t value);
void SysTick_Handler();
void TIM1_UP_IRQHandler();
void TIM2_IRQHandler();
void USART1_IRQHandler();
void EXTI9_5_IRQHandler();
void EXTI15_10_IRQHandler();
}
