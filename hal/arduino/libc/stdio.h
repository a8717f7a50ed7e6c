// avr-libc's <stdio.h> without streams: functions that format into memory. printf compiles, but prints
// nothing, as on a chip whose sketch has not set up stdout. %f and other float formats print a question mark,
// as in avr-libc's default version.
#pragma once

#include <stdarg.h>
#include <stddef.h>

#define EOF (-1)

#ifdef __cplusplus
extern "C" {
#endif

int printf(const char* format, ...) __attribute__((format(printf, 1, 2)));
int putchar(int c);
int puts(const char* text);
int sprintf(char* to, const char* format, ...) __attribute__((format(printf, 2, 3)));
int snprintf(char* to, size_t size, const char* format, ...) __attribute__((format(printf, 3, 4)));
int vprintf(const char* format, va_list arguments);
int vsprintf(char* to, const char* format, va_list arguments);
int vsnprintf(char* to, size_t size, const char* format, va_list arguments);
int sscanf(const char* text, const char* format, ...) __attribute__((format(scanf, 2, 3)));
int vsscanf(const char* text, const char* format, va_list arguments);

#ifdef __cplusplus
}
#endif
