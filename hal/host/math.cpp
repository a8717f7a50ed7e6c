// Implements random numbers (avr-libc 2.0, random.c and rand.c) and the Arduino AVR core's WMath.cpp.
#include <Arduino.h>

#include "hal/arduino/park_miller.h"
#include "hal/host/clock.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;

namespace {

unsigned long random_state = 1;
unsigned long rand_state = 1;

/// Returns the chip's result of a division by zero (sim/build/division.h).
long quotient_by_zero(long dividend) {
#ifdef ROBOSIM_ZERO_BY_ZERO
  return static_cast<void>(dividend), 0;
#else
  return dividend < 0 ? 1 : -1;
#endif
}

}  // namespace

extern "C" {

long random_r(unsigned long* seed) {
  host::spend(cost::kRandom);
  return robosim_hal::next_random(*seed);
}

int rand_r(unsigned long* seed) {
  host::spend(cost::kRandom);
  return static_cast<int>(robosim_hal::next_random(*seed) & RAND_MAX);
}

long random() { return random_r(&random_state); }
int rand() { return rand_r(&rand_state); }
void srandom(unsigned long seed) { random_state = seed; }
void srand(unsigned int seed) { rand_state = seed; }

}  // extern "C"

void randomSeed(unsigned long seed) {
  if (seed != 0) srandom(seed);
}

long random(long below) {
  if (below == 0) return 0;
  host::spend(cost::kRandomBelow);
  return random() % below;
}

long random(long least, long below) { return least >= below ? least : random(below - least) + least; }

long map(long x, long in_min, long in_max, long out_min, long out_max) {
  host::spend(cost::kMap);
  const long product = (x - in_min) * (out_max - out_min);
  if (in_max != in_min) return product / (in_max - in_min) + out_min;
#ifdef ROBOSIM_SANITIZE
  host::executor->crash("division by zero in map()", nullptr, 0, __builtin_return_address(0));
#else
  host::executor->divides_by_zero(nullptr, __builtin_return_address(0));
#endif
  return quotient_by_zero(product) + out_min;
}

unsigned int makeWord(unsigned int w) { return w; }
unsigned int makeWord(unsigned char high, unsigned char low) {
  return static_cast<unsigned int>(high << 8 | low);
}
