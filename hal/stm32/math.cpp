// Provides the functions of the Arduino core's WMath.cpp, and the same random numbers as on an Uno.
#include <Arduino.h>

#include "hal/arduino/park_miller.h"

namespace {

unsigned long random_state = 1;
unsigned long rand_state = 1;

}  // namespace

extern "C" {

long random_r(unsigned long* seed) { return robosim_hal::next_random(*seed); }
int rand_r(unsigned long* seed) { return static_cast<int>(robosim_hal::next_random(*seed) & RAND_MAX); }
long random() { return random_r(&random_state); }
int rand() { return rand_r(&rand_state); }
void srandom(unsigned long seed) { random_state = seed; }
void srand(unsigned int seed) { rand_state = seed; }

}  // extern "C"

void randomSeed(unsigned long seed) {
  if (seed != 0) srandom(seed);
}

long random(long below) { return below == 0 ? 0 : random() % below; }

long random(long least, long below) { return least >= below ? least : random(below - least) + least; }

long map(long x, long in_min, long in_max, long out_min, long out_max) {
  return (x - in_min) * (out_max - out_min) / (in_max - in_min) + out_min;
}

unsigned int makeWord(unsigned int w) { return w; }
unsigned int makeWord(unsigned char high, unsigned char low) {
  return static_cast<unsigned int>(high << 8 | low);
}
