#pragma once
#include <Arduino.h>

void addTask(void (*task)(), uint8_t* stack, uint16_t size);
void startKernel();
void waitTicks(uint16_t ticks);
