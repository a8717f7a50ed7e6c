// Enables and disables all interrupts by PRIMASK. Handlers have STM32 names, such as void TIM3_IRQHandler().
#pragma once

#include <avr/io.h>

#define sei() __asm__ volatile("cpsie i" ::: "memory")
#define cli() __asm__ volatile("cpsid i" ::: "memory")
