// avr-libc 2.0's clock, which counts seconds since 2000. Only the sketch advances the clock. The calendar
// functions of avr-libc are missing.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef uint32_t time_t;

/// Returns the clock's value: seconds since 1 January 2000, 0:00. Also stores the value in *seconds, unless
/// `seconds` is null.
time_t time(time_t* seconds);
int32_t difftime(time_t later, time_t earlier);
void set_system_time(time_t seconds);
/// Advances the clock by a second. The sketch must call this function once a second.
void system_tick(void);

#ifdef __cplusplus
}
#endif
