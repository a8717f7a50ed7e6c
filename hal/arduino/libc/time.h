// A clock as avr-libc 2.0 has it: seconds since 2000, which stand still unless the sketch ticks them. Of its
// calendar there is nothing here.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef uint32_t time_t;

/// Seconds since 1 January 2000, 0:00, as they were set and ticked; into *seconds, too, unless that is null.
time_t time(time_t* seconds);
int32_t difftime(time_t later, time_t earlier);
void set_system_time(time_t seconds);
/// To be called once a second.
void system_tick(void);

#ifdef __cplusplus
}
#endif
