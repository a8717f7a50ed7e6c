// attachInterrupt (WInterrupts.c of the Arduino AVR core).
#include <Arduino.h>

#include "hal/host/api.h"
#include "hal/host/external.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNoPin;
using robosim::Pin;

namespace {

void (*attached[host::kExternals])();
void (*attached_to_line[host::kPins])();

void run_attached(int number) {
  host::spend(cost::kAttachedHandler);
  if (attached[number]) attached[number]();
}

Pin pin_of(uint8_t number) {
  if (number < host::kExternals) return host::pin_of_external(number);
  return host::has_line(number) ? number : kNoPin;
}

void attach_line(Pin pin, void (*handler)(), int mode) {
  attached_to_line[pin] = handler;
  host::lines.sense[pin] = static_cast<uint8_t>(mode);
  host::lines.flags.remove(pin);
  host::lines.enabled.add(pin);
}

void detach_line(Pin pin) {
  host::lines.enabled.remove(pin);
  attached_to_line[pin] = nullptr;
}

}  // namespace

extern "C" {

void robosim_serve_line() {
  const Pin pin = host::take_line();
  host::spend(cost::kAttachedHandler);
  if (pin != kNoPin && attached_to_line[pin]) attached_to_line[pin]();
}

static_assert(host::kExternal0 == 1 && host::kExternals == 2, "the handlers' names");
__attribute__((weak)) void __vector_1() { run_attached(0); }
__attribute__((weak)) void __vector_2() { run_attached(1); }

void attachInterrupt(uint8_t number, void (*handler)(), int mode) {
  const Pin pin = pin_of(number);
  host::note_call("attachInterrupt", pin, 2, number, mode);
  host::spend(cost::kAttachInterrupt);
  if (pin == kNoPin) return;
  if (number >= host::kExternals) {
    attach_line(pin, handler, mode);
  } else {
    attached[number] = handler;
    const int shift = 2 * number;
    host::external.sense = static_cast<uint8_t>((host::external.sense & ~(3 << shift)) | (mode & 3) << shift);
    host::external.mask |= static_cast<uint8_t>(1 << number);
  }
  host::refresh_external();
  host::refresh_deadline();
}

void detachInterrupt(uint8_t number) {
  const Pin pin = pin_of(number);
  host::note_call("detachInterrupt", pin, 1, number);
  host::spend(cost::kAttachInterrupt);
  if (pin == kNoPin) return;
  if (number >= host::kExternals) {
    detach_line(pin);
  } else {
    host::external.mask &= static_cast<uint8_t>(~(1 << number));
    attached[number] = nullptr;
  }
  host::refresh_external();
  host::refresh_deadline();
}

}  // extern "C"
