#include "resolution.h"

namespace robosim_hal {

int read_bits = 10;
int write_bits = 8;

namespace {
bool has_range(int bits) { return bits >= 1 && bits <= 16; }
}  // namespace

extern "C" {

void analogReadResolution(int bits) {
  if (has_range(bits)) read_bits = bits;
}

void analogWriteResolution(int bits) {
  if (has_range(bits)) write_bits = bits;
}

}  // extern "C"

}  // namespace robosim_hal
