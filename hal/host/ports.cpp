#include "hal/host/ports.h"

#include "hal/host/clock.h"
#include "hal/host/external.h"
#include "hal/host/timers.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

PortRegisters ports[kPorts];
ROBOSIM_CLOCKWORK Place places[kNumbers];  // constant after place_pins()

ROBOSIM_SETTINGS PinDrive driven[kPins];
uint16_t inputs_off;

namespace {

bool pull_ups_off;

ROBOSIM_SETTINGS uint32_t tone_hz[kPins];
ROBOSIM_SETTINGS uint8_t pwm_values[kPins];  // PWM values of pins without a timer

// The pins by port and bit, by timer and channel, and by other function. Constant after place_pins().
ROBOSIM_CLOCKWORK Pin port_pins[kPorts][kBits];
ROBOSIM_CLOCKWORK Pin timer_pins[kTimers][2];
ROBOSIM_CLOCKWORK Pin external_pins[kChip.external_count];
ROBOSIM_CLOCKWORK Pin capture_pin, comparator_pins[2];

bool is_same(const char* a, const char* b) {
  while (*a && *a == *b) ++a, ++b;
  return *a == *b;
}

void place_on_chip(Pin pin, const ChipPin& at) {
  Place& place = places[pin];
  if (at.port < 0) return;
  place.digital = true;
  place.port = static_cast<Port>(at.port);
  place.mask = static_cast<uint8_t>(1 << at.bit);
  place.external = at.external;
  place.counted_by = at.counted_by;
  place.captured_by = at.captured_by;
  if (at.captured_by >= 0) capture_pin = pin;
  if (at.analog_channel >= 0) place.off_bits = static_cast<uint16_t>(1 << at.analog_channel);
  if (is_same(at.name, kChip.comparator.positive)) comparator_pins[0] = pin;
  if (is_same(at.name, kChip.comparator.negative)) comparator_pins[1] = pin;
  if (at.change >= 0) {
    place.change_group = static_cast<int8_t>(at.change / 8);
    place.change_mask = static_cast<uint8_t>(1 << at.change % 8);
  }
  port_pins[at.port][at.bit] = pin;
  if (at.external >= 0) external_pins[at.external] = pin;
}

/// Connects the pin to the simulated timer that has the number and the width of the pin's own timer. OC2A is
/// therefore pin 10 of a Mega, and pin 11 of an Uno.
void place_timer(Pin pin, const BoardSpec& board) {
  const bool is_avr = is_same(board.chip->target, kChip.target);
  const BoardSpec& source = is_avr ? board : host_model(board);
  if (pin >= source.pin_count || first_number(source, pin) != pin) return;
  const ChipPin& at = source.pins[pin].chip_pin;
  if (at.timer < 0) return;
  const TimerSpec& own = source.chip->timers[at.timer];
  for (int8_t i = 0; i < kTimers; ++i) {
    if (kChip.timers[i].number != own.number || kChip.timers[i].bits != own.bits || at.output > 1) continue;
    places[pin].timer.timer = i;
    places[pin].timer.channel = static_cast<int8_t>(at.output);
    timer_pins[i][at.output] = pin;
  }
}

PinDrive drive_of(Pin pin) {
  const PortRegisters& port = ports[port_of(pin)];
  const uint8_t mask = mask_of(pin);
  if (!(port.direction & mask)) {
    const bool pulls_up = port.output & mask && !pull_ups_off;
    return {pulls_up ? PinMode::input_pullup : PinMode::input, false, false, 0.0, 0, 0};
  }
  const TimerPin by = timer_of(pin);
  if (is_timed(pin)) return timer(by.timer).drive(by.channel);
  if (tone_hz[pin]) return {PinMode::output, false, true, 0.5, tone_hz[pin], 0};
  if (pwm_values[pin]) return {PinMode::output, false, true, pwm_values[pin] / 255.0, 0, 0};
  return PinDrive::constant(port.output & mask);
}

void refresh_port(Port port, uint8_t changed) {
  for (int bit = 0; bit < kBits; ++bit)
    if (changed >> bit & 1 && port_pins[port][bit] != kNoPin) refresh_pin(port_pins[port][bit]);
}

}  // namespace

bool is_timed(Pin pin) {
  const TimerPin by = timer_of(pin);
  return by.timer >= 0 && timer(by.timer).drives(by.channel);
}

bool is_wave(Pin pin) { return driven[pin].pwm && (is_timed(pin) || tone_hz[pin]); }

bool output_level(Pin pin) {
  const PinDrive& drive = driven[pin];
  return !drive.pwm ? drive.level : is_wave(pin) ? wave_level(pin) : drive.duty >= 0.5;
}

Pin pin_of_external(int number) { return external_pins[number]; }

Pin pin_of_capture() { return capture_pin; }
Pin pin_of_comparator(int input) { return comparator_pins[input]; }

void place_pins() {
  for (auto& pins : port_pins)
    for (Pin& pin : pins) pin = kNoPin;
  for (auto& pins : timer_pins)
    for (Pin& pin : pins) pin = kNoPin;
  for (Pin& pin : external_pins) pin = kNoPin;
  for (Pin& pin : comparator_pins) pin = kNoPin;
  const BoardSpec& spec = *board_spec;
  const BoardSpec& model = host_model(spec);
  for (Pin pin = 0; pin < spec.pin_count; ++pin) {
    const bool as_pin = pin >= spec.analog_pin_0;
    places[pin].wired = first_number(spec, pin);
    places[pin].no_channel =
        spec.pins[pin].analog_channel >= 0 &&
        (as_pin ? pin >= spec.analog_pin_0 + kChip.adc.pins : pin >= ROBOSIM_ANALOG_INPUTS);
  }
  for (Pin pin = 0; pin < kPins && pin < spec.pin_count; ++pin) {
    place_timer(pin, spec);
    if (pin < model.pin_count) {
      place_on_chip(pin, model.pins[pin].chip_pin);
      continue;
    }
    const int number = pin - model.pin_count;
    Place& place = places[pin];
    place.digital = spec.pins[pin].digital;
    place.port = static_cast<Port>(kChip.port_count + number / kBits);
    place.mask = static_cast<uint8_t>(1 << number % kBits);
    port_pins[place.port][number % kBits] = pin;
  }
  for (int input = 0; input < 2; ++input)
    if (comparator_pins[input] != kNoPin)
      places[comparator_pins[input]].off_bits = static_cast<uint16_t>(0x100 << input);
}

void refresh_pin(Pin pin) {
  const PinDrive drive = drive_of(pin);
  if (drive == driven[pin]) return;
  const bool is_heard = heard.has(pin);
  if (is_heard) hear();
  driven[pin] = drive;
  board->set_drive(pin, drive, state.now);
  if (is_heard) drive_changed(pin);
}

void refresh_timer_pins(int number) {
  for (const Pin pin : timer_pins[number])
    if (pin != kNoPin) refresh_pin(pin);
}

void set_direction(Port port, uint8_t value) {
  const uint8_t changed = ports[port].direction ^ value;
  ports[port].direction = value;
  refresh_port(port, changed);
}

void set_pull_ups_off(bool off) {
  if (off == pull_ups_off) return;
  pull_ups_off = off;
  for (Port port = 0; port < kPorts; ++port) refresh_port(port, 0xFF);
}

void set_output(Port port, uint8_t value) {
  const uint8_t changed = ports[port].output ^ value;
  ports[port].output = value;
  refresh_port(port, changed);
}

bool read_pin(Pin pin) {
  if (__builtin_expect(is_input_off(pin), 0)) return false;
  const bool level = board->read_level(pin, state.now);
  return pin < kPins && driven[pin].pwm ? output_level(pin) : level;
}

uint8_t read_port(Port port) {
  uint8_t value = 0;
  for (int bit = 0; bit < kBits; ++bit) {
    const Pin pin = port_pins[port][bit];
    if (pin == kNoPin || is_input_off(pin)) continue;
    const bool level = board->read_level(pin, state.now, ReadIntent::port);
    if (driven[pin].pwm ? output_level(pin) : level) value |= static_cast<uint8_t>(1 << bit);
  }
  return value;
}

void set_pwm(Pin pin, uint8_t value) {
  pwm_values[pin] = value;
  refresh_pin(pin);
}

bool end_pwm(Pin pin) {
  if (pin >= kPins || !pwm_values[pin]) return false;
  pwm_values[pin] = 0;
  return true;
}

void set_tone(Pin pin, uint32_t hz) {
  tone_hz[pin] = hz;
  refresh_pin(pin);
}

}  // namespace host
}  // namespace robosim
