#include "hal/host/external.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {

ExternalRegisters external;
Lines lines;

namespace {

constexpr Pin kFirstPin = 2;  // of INT0
bool low[2];                  // the level of a pin whose low level interrupts

/// Whether an edge to this level is one that `sense` asks for.
bool is_edge(int sense, bool level) { return sense == kAnyEdge || sense == (level ? kRising : kFalling); }

int sense_of(int number) { return external.sense >> 2 * number & 3; }

}  // namespace

bool has_line(Pin pin) {
  const BoardSpec& spec = board->spec();
  return pin >= kFirstPin + 2 && pin < kMostPins && pin < spec.pin_count && spec.pins[pin].interrupt >= 0;
}

Pin take_line() {
  const uint32_t raised = lines.flags & lines.enabled;
  if (!raised) return kNoPin;
  const int pin = __builtin_ctz(raised);
  lines.flags &= ~(1u << pin);
  return static_cast<Pin>(pin);
}

void refresh_external() {
  for (Pin pin = kPortPins; pin < kMostPins; ++pin)
    executor->want_edges(pin, lines.enabled >> pin & 1, state.now);
  for (Pin pin = 0; pin < kPortPins; ++pin) {
    const Port port = port_of(pin);
    bool wanted = external.change_control >> port & 1 && external.change_mask[port] & mask_of(pin);
    for (int number = 0; number < 2; ++number)
      wanted = wanted || (pin == kFirstPin + number && external.mask >> number & 1);
    executor->want_edges(pin, wanted || lines.enabled >> pin & 1, state.now);
  }
  for (int number = 0; number < 2; ++number)
    low[number] = external.mask >> number & 1 && sense_of(number) == 0 &&
                  !board->read_level(static_cast<Pin>(kFirstPin + number), state.now);
}

void external_edge(Pin pin, bool level) {
  const int number = pin - kFirstPin;
  if (number == 0 || number == 1) {
    const int sense = sense_of(number);
    low[number] = sense == 0 && !level;
    if (is_edge(sense, level)) external.flags |= static_cast<uint8_t>(1 << number);
  }
  if (pin < kMostPins && lines.enabled >> pin & 1 && is_edge(lines.sense[pin], level))
    lines.flags |= 1u << pin;
  if (pin < kPortPins && external.change_mask[port_of(pin)] & mask_of(pin))
    external.change_flags |= static_cast<uint8_t>(1 << port_of(pin));
}

uint32_t pending_external() {
  const uint32_t levels = static_cast<uint32_t>(low[0]) | static_cast<uint32_t>(low[1]) << 1;
  const uint32_t edges = (external.flags | levels) & external.mask & 3;
  const uint32_t changes = external.change_flags & external.change_control & 7;
  return edges << 1 | changes << 3 | (lines.flags & lines.enabled ? 1u << kLines : 0u);
}

void acknowledge_external(int number) {
  if (number <= 2) {
    external.flags &= static_cast<uint8_t>(~(1 << (number - 1)));
  } else {
    external.change_flags &= static_cast<uint8_t>(~(1 << (number - 3)));
  }
}

void reset_external() {
  external = ExternalRegisters();
  lines = Lines();
  low[0] = low[1] = false;
}

}  // namespace host
}  // namespace robosim
