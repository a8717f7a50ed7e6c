// avr-libc's <stdlib.h>: the C standard's functions, and itoa, dtostrf and random.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  int quot;
  int rem;
} div_t;
typedef struct {
  long quot;
  long rem;
} ldiv_t;

#define RAND_MAX 0x7FFF
#define RANDOM_MAX 0x7FFFFFFFL
#define EXIT_SUCCESS 0
#define EXIT_FAILURE 1

#define DTOSTR_ALWAYS_SIGN 0x01
#define DTOSTR_PLUS_SIGN 0x02
#define DTOSTR_UPPERCASE 0x04

void abort(void) __attribute__((noreturn));
void exit(int status) __attribute__((noreturn));
int abs(int i);
long labs(long i);
div_t div(int numerator, int denominator);
ldiv_t ldiv(long numerator, long denominator);
void* bsearch(const void* key, const void* base, size_t count, size_t size,
              int (*compare)(const void*, const void*));
void qsort(void* base, size_t count, size_t size, int (*compare)(const void*, const void*));

int atoi(const char* text);
long atol(const char* text);
double atof(const char* text);
long strtol(const char* text, char** end, int base);
unsigned long strtoul(const char* text, char** end, int base);
double strtod(const char* text, char** end);

void* malloc(size_t size);
void* calloc(size_t count, size_t size);
void* realloc(void* memory, size_t size);
void free(void* memory);

/// Converts a number to text and returns `text`; `radix` is 2..36.
char* itoa(int value, char* text, int radix);
char* ltoa(long value, char* text, int radix);
char* utoa(unsigned int value, char* text, int radix);
char* ultoa(unsigned long value, char* text, int radix);
/// Formats a number in fixed point, with at least `width` characters. A negative `width` aligns to the left.
char* dtostrf(double value, signed char width, unsigned char decimals, char* text);
/// Formats a number with an exponent, such as 1.23e+04. `flags` are DTOSTR_ bits.
char* dtostre(double value, char* text, unsigned char decimals, unsigned char flags);

/// avr-libc's random number generators. They return the same numbers as on the chip.
int rand(void);
void srand(unsigned int seed);
int rand_r(unsigned long* state);
long random(void);
void srandom(unsigned long seed);
long random_r(unsigned long* state);

#ifdef __cplusplus
}
#endif
