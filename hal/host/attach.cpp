// Implements attachInterrupt() (WInterrupts.c of the Arduino AVR core).
#include <Arduino.h>

#include "hal/board/board_spec.h"
#include "hal/host/api.h"
#include "hal/host/external.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNoPin;
using robosim::Pin;

namespace {

void (*attached[host::kExternals])();
ROBOSIM_SETTINGS void (*attached_to_line[host::kPins])();

void run_attached(int number) {
  host::spend(cost::kAttachedHandler);
  if (attached[number]) attached[number]();
}

/// Returns the pin that has the interrupt `number` on this board. Otherwise, returns the pin of the chip's
/// INTn, where n is `number`; kNoPin if the chip has no such interrupt.
Pin pin_of(uint8_t number) {
  const robosim::BoardSpec& spec = host::board->spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    if (spec.pins[pin].interrupt == number && (host::places[pin].external >= 0 || host::has_line(pin)))
      return pin;
  return number < host::kExternals ? host::pin_of_external(number) : kNoPin;
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
  if (pin == kNoPin)
    return host::executor->acted({robosim::FirmwareAction::Kind::attach_interrupt, {number, mode, 0}});
  const int external = host::places[pin].external;
  if (external < 0) {
    attach_line(pin, handler, mode);
  } else {
    attached[external] = handler;
    const int shift = 2 * external;
    host::external.sense = static_cast<uint8_t>((host::external.sense & ~(3 << shift)) | (mode & 3) << shift);
    host::external.mask |= static_cast<uint8_t>(1 << external);
  }
  host::refresh_external();
  host::refresh_deadline();
}

void detachInterrupt(uint8_t number) {
  const Pin pin = pin_of(number);
  host::note_call("detachInterrupt", pin, 1, number);
  host::spend(cost::kAttachInterrupt);
  if (pin == kNoPin) return;
  const int external = host::places[pin].external;
  if (external < 0) {
    detach_line(pin);
  } else {
    host::external.mask &= static_cast<uint8_t>(~(1 << external));
    attached[external] = nullptr;
  }
  host::refresh_external();
  host::refresh_deadline();
}

}  // extern "C"
