#include "hal/host/external.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

ExternalRegisters external;
Lines lines;
PinSet heard;

namespace {

ROBOSIM_CLOCKWORK bool heard_level[kPins];  // last level of each pin in `heard`

/// Returns whether an edge to this level matches `sense`.
bool is_edge(int sense, bool level) { return sense == kAnyEdge || sense == (level ? kRising : kFalling); }

bool is_counted(Pin pin) {
  return places[pin].counted_by >= 0 && timer(places[pin].counted_by).counts_edges();
}

bool is_captured(Pin pin) {
  return places[pin].captured_by >= 0 && timer(places[pin].captured_by).captures_edges();
}

int sense_of(int number) { return external.sense >> 2 * number & 3; }

void set_low(int number, bool low) {
  const auto bit = static_cast<uint8_t>(1 << number);
  external.low = static_cast<uint8_t>(low ? external.low | bit : external.low & ~bit);
}

}  // namespace

bool has_line(Pin pin) {
  // Interrupt numbers below kExternals belong to INTn.
  const BoardSpec& spec = *board_spec;
  return places[pin].external < 0 && pin < kPins && pin < spec.pin_count &&
         spec.pins[pin].interrupt >= kExternals;
}

Pin take_line() {
  const Pin pin = lines.flags.first_common(lines.enabled);
  if (pin != kNoPin) lines.flags.remove(pin);
  return pin;
}

void refresh_external() {
  for (Pin pin = 0; pin < kPins; ++pin) {
    const Place& place = places[pin];
    // Flags are set regardless of the enable bits (13.2.3, 13.2.5).
    const bool by_change =
        place.change_group >= 0 && external.change_mask[place.change_group] & place.change_mask;
    const bool by_itself =
        place.external >= 0 && (external.mask >> place.external & 1 || sense_of(place.external) != 0);
    const bool wanted =
        by_change || by_itself || is_counted(pin) || is_captured(pin) || lines.enabled.has(pin);
    const bool found = executor->want_edges(pin, wanted, state.now);
    if (heard.has(pin) == wanted) continue;
    if (wanted) {
      heard.add(pin);
      heard_level[pin] = is_output(pin) ? output_level(pin) : found;
    } else {
      heard.remove(pin);
    }
    refresh_wave(pin);
  }
  for (int number = 0; number < kExternals; ++number) {
    if (sense_of(number) == 0) external.flags &= static_cast<uint8_t>(~(1 << number));
    set_low(number,
            external.mask >> number & 1 && sense_of(number) == 0 && !read_pin(pin_of_external(number)));
  }
}

void hear() {
  sync_waves();
  take_inputs();
}

void drive_changed(Pin pin) {
  hear_level(pin, is_output(pin) ? output_level(pin) : board->read_level(pin, state.now, ReadIntent::port),
             state.now);
  refresh_wave(pin);
  refresh_deadline();
}

void external_edge(Pin pin, bool level, SimTime at) {
  if (heard.has(pin) && !is_output(pin)) hear_level(pin, level, at);
}

void hear_level(Pin pin, bool level, SimTime at) {
  if (heard_level[pin] == level) return;
  heard_level[pin] = level;
  const Place& place = places[pin];
  const int number = place.external;
  if (number >= 0) {
    const int sense = sense_of(number);
    set_low(number, sense == 0 && !level);
    if (is_edge(sense, level)) external.flags |= static_cast<uint8_t>(1 << number);
  }
  if (place.counted_by >= 0) timer(place.counted_by).count_edge(level);
  if (is_captured(pin)) timer(place.captured_by).capture_edge(level, at);
  if (lines.enabled.has(pin) && is_edge(lines.sense[pin], level)) lines.flags.add(pin);
  if (place.change_group >= 0 && external.change_mask[place.change_group] & place.change_mask)
    external.change_flags |= static_cast<uint8_t>(1 << place.change_group);
}

bool external_may_interrupt() {
  if (external.mask & ((1u << kExternals) - 1)) return true;
  for (int group = 0; group < kChip.change_count; ++group)
    if (external.change_control >> group & 1 && external.change_mask[group]) return true;
  return lines.enabled.any();
}

void acknowledge_external(int vector) {
  if (vector < kPinChange0) {
    external.flags &= static_cast<uint8_t>(~(1 << (vector - kExternal0)));
  } else {
    external.change_flags &= static_cast<uint8_t>(~(1 << (vector - kPinChange0)));
  }
}

}  // namespace host
}  // namespace robosim
