// Computes quotient and remainder for a divisor in a register and in memory, at one optimisation level.
#pragma once

#include <Arduino.h>

inline void show(uint64_t bits) {
  Serial.print((uint32_t)(bits >> 32), HEX);
  Serial.print(' ');
  Serial.println((uint32_t)bits, HEX);
}

#define DIVISIONS_AT(LEVEL)                                                                             \
  namespace at_##LEVEL {                                                                                \
    template <typename T>                                                                               \
    __attribute__((noinline, optimize(#LEVEL))) void by_register(T a, T b, T* quotient, T* remainder) { \
      *quotient = a / b;                                                                                \
      *remainder = a % b;                                                                               \
    }                                                                                                   \
    template <typename T>                                                                               \
    __attribute__((noinline, optimize(#LEVEL))) void by_memory(T a, volatile T* b, T* quotient,         \
                                                               T* remainder) {                          \
      *quotient = a / *b;                                                                               \
      *remainder = a % *b;                                                                              \
    }                                                                                                   \
    template <typename T>                                                                               \
    void divide(T a, T b) {                                                                             \
      volatile T stored = b;                                                                            \
      T q, r;                                                                                           \
      by_register<T>(a, b, &q, &r);                                                                     \
      show(q), show(r);                                                                                 \
      by_memory<T>(a, &stored, &q, &r);                                                                 \
      show(q), show(r);                                                                                 \
    }                                                                                                   \
    template <typename T>                                                                               \
    void divide_all(T lowest) {                                                                         \
      divide<T>(100, 0);                                                                                \
      divide<T>(-100, 0);                                                                               \
      divide<T>(lowest, -1);                                                                            \
      divide<T>(lowest, 7);                                                                             \
    }                                                                                                   \
    inline void all_types() {                                                                           \
      divide_all<int8_t>(INT8_MIN);                                                                     \
      divide_all<uint8_t>(200);                                                                         \
      divide_all<int16_t>(INT16_MIN);                                                                   \
      divide_all<uint16_t>(60000);                                                                      \
      divide_all<int32_t>(INT32_MIN);                                                                   \
      divide_all<uint32_t>(4000000000);                                                                 \
      divide_all<int64_t>(INT64_MIN);                                                                   \
      divide_all<uint64_t>(10000000000000000000ull);                                                    \
    }                                                                                                   \
  }

DIVISIONS_AT(O0)
DIVISIONS_AT(Os)
DIVISIONS_AT(O2)
