// All interrupts on and off, by PRIMASK. Handlers have names of their own here: void TIM3_IRQHandler().
#pragma once

#include <avr/io.h>

#define sei() __asm__ volatile("cpsie i" ::: "memory")
#define cli() __asm__ volatile("cpsid i" ::: "memory")
