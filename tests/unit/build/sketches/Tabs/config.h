#pragma once
#define BAUD 9600
#define SECOND 2
#define LED_PIN LED_BUILTIN
#ifdef __cplusplus
extern "C"
#endif
    int
    sum_of(int a, int b);
