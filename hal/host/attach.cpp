// attachInterrupt (WInterrupts.c of the Arduino AVR core).
#include <Arduino.h>

#include "hal/host/api.h"
#include "hal/host/external.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNoPin;

namespace {

void (*attached[2])();

void run_attached(int number) {
  host::spend(cost::kAttachedHandler);
  if (attached[number]) attached[number]();
}

}  // namespace

extern "C" {

__attribute__((weak)) void __vector_1() { run_attached(0); }
__attribute__((weak)) void __vector_2() { run_attached(1); }

void attachInterrupt(uint8_t number, void (*handler)(), int mode) {
  host::note_call("attachInterrupt", number < 2 ? static_cast<robosim::Pin>(number + 2) : kNoPin, 2, number,
                  mode);
  host::spend(cost::kAttachInterrupt);
  if (number >= 2) return;
  attached[number] = handler;
  const int shift = 2 * number;
  host::external.sense = static_cast<uint8_t>((host::external.sense & ~(3 << shift)) | (mode & 3) << shift);
  host::external.mask |= static_cast<uint8_t>(1 << number);
  host::refresh_external();
  host::refresh_deadline();
}

void detachInterrupt(uint8_t number) {
  host::note_call("detachInterrupt", number < 2 ? static_cast<robosim::Pin>(number + 2) : kNoPin, 1, number);
  host::spend(cost::kAttachInterrupt);
  if (number >= 2) return;
  host::external.mask &= static_cast<uint8_t>(~(1 << number));
  attached[number] = nullptr;
  host::refresh_external();
  host::refresh_deadline();
}

}  // extern "C"
