// Implements avr-libc's clock.
#include <time.h>

namespace {
volatile time_t seconds_now = 0;
}  // namespace

extern "C" {

time_t time(time_t* seconds) {
  const time_t now = seconds_now;
  if (seconds) *seconds = now;
  return now;
}

int32_t difftime(time_t later, time_t earlier) { return static_cast<int32_t>(later - earlier); }

void set_system_time(time_t seconds) { seconds_now = seconds; }

void system_tick(void) { seconds_now = seconds_now + 1; }

}  // extern "C"
