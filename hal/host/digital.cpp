// Implements functions for digital and analog pins (the AVR core's wiring_digital.c, wiring_analog.c and
// wiring_shift.c).
#include <Arduino.h>

#include "hal/arduino/resolution.h"
#include "hal/board/avr_adc.h"
#include "hal/board/board_spec.h"
#include "hal/host/adc.h"
#include "hal/host/api.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;

namespace {

uint8_t reference = DEFAULT;

constexpr int kAdcBits = host::kChip.adc.bits, kPwmBits = 8, kPwmOn = (1 << kPwmBits) - 1;
constexpr int kLastChannel = host::kChip.adc.pins - 1;

/// Sets the mode of a pin. Returns whether anything has changed.
bool set_mode(uint8_t pin, uint8_t mode) {
  const host::Port port = host::port_of(pin);
  const uint8_t mask = host::mask_of(pin);
  host::PortRegisters& registers = host::ports[port];
  const host::PortRegisters before = registers;
  if (mode == INPUT || mode == INPUT_PULLUP) {
    registers.direction &= static_cast<uint8_t>(~mask);
    if (mode == INPUT) {
      registers.output &= static_cast<uint8_t>(~mask);
    } else {
      registers.output |= mask;
    }
  } else {
    registers.direction |= mask;
  }
  return before.direction != registers.direction || before.output != registers.output;
}

/// Disconnects PWM from a pin before a read or write. Like the core, clears only the bit COMxx1. Returns
/// whether the pin had PWM.
bool disconnect(uint8_t pin) {
  const host::TimerPin by = host::timer_of(pin);
  if (by.timer < 0) return host::end_pwm(pin);
  host::Timer& timer = host::timer(by.timer);
  const uint8_t connection = timer.connection(by.channel);
  if (!(connection & 2)) return false;
  timer.set_connection(by.channel, connection & 1);
  return true;
}

void set_level(uint8_t pin, bool level) {
  const bool disconnected = disconnect(pin);
  uint8_t& output = host::ports[host::port_of(pin)].output;
  const uint8_t mask = host::mask_of(pin);
  const auto value = static_cast<uint8_t>(level ? output | mask : output & ~mask);
  if (value == output && !disconnected) return;
  output = value;
  host::refresh_pin(pin);
}

int timer_cost(uint8_t pin) { return host::timer_of(pin).timer < 0 ? 0 : cost::kTimerPin; }

bool get_level(uint8_t pin) {
  if (disconnect(pin)) {
    host::state.touched = true;
    host::refresh_pin(pin);
  }
  return host::read_pin(pin);
}

/// Reports a number that is not a digital pin. `function` is an index in kPinFunctions.
void report_missing(uint8_t number, int64_t function) {
  host::executor->acted({robosim::FirmwareAction::Kind::missing_pin, {number, function, 0}});
}

}  // namespace

extern "C" {

void pinMode(uint8_t pin, uint8_t mode) {
  host::note_call("pinMode", pin, 2, pin, mode);
  host::spend(cost::kPinMode);
  if (!host::is_digital(pin)) return report_missing(pin, 0);
  set_mode(pin, mode);
  host::refresh_pin(pin);
}

ROBOSIM_FREQUENT void digitalWrite(uint8_t pin, uint8_t value) {
  host::note_call("digitalWrite", pin, 2, pin, value);
  host::spend(cost::kDigitalWrite + timer_cost(pin));
  if (!host::is_digital(pin)) return report_missing(pin, 1);
  set_level(pin, value != LOW);
}

int digitalRead(uint8_t pin) {
  host::note_question("digitalRead", pin, 1, pin);
  host::note_read(pin);
  host::spend_asking(cost::kDigitalRead + timer_cost(pin));
  if (!host::is_digital(pin)) {
    report_missing(pin, 2);
    return LOW;
  }
  const bool high = get_level(pin);
  host::note_level(pin, high);
  return high ? HIGH : LOW;
}

void analogReference(uint8_t mode) {
  host::note_call("analogReference", robosim::kNoPin, 1, mode);
  reference = mode;
}

ROBOSIM_FREQUENT int analogRead(uint8_t pin) {
  // Accepts two kinds of numbers, as the core does: 8 means A8, and so does the pin number of A8.
  const bool above = pin < NUM_ANALOG_INPUTS && pin > kLastChannel;
  const auto number = static_cast<uint8_t>(above ? PIN_A0 + pin : pin);
  const bool elsewhere = host::places[number].no_channel;
  if (pin >= PIN_A0) pin -= PIN_A0;
  const int channel = pin & kLastChannel;
  host::note_call("analogRead", static_cast<robosim::Pin>(elsewhere ? number : PIN_A0 + channel), 1, pin);
  host::note_conversion();
  const uint8_t before = host::adc.multiplexer();
  host::adc.set_multiplexer(static_cast<uint8_t>(reference << 6 | channel));
  host::spend(cost::kAnalogRead);
  // The capacitor is charged from now on, because the core writes ADMUX just before the conversion.
  if (host::adc.multiplexer() != before) host::adc.charge();
  if (!host::adc.on()) return 0;
  const robosim::SimTime clock = host::adc.clock();
  const robosim::SimTime start = host::adc.next_start(clock);
  const bool first = host::adc.take_first(true);
  host::wait_until(start + robosim::avr::adc_half_clocks_to_sample(first) * clock / 2);
  const uint16_t code =
      elsewhere ? host::adc.code_of(host::board->read_volts(host::places[number].wired, host::state.now))
                : host::adc.sample(0);
  host::wait_until(start + robosim::avr::adc_clocks(first) * clock);
  host::adc.charge();
  return robosim_hal::with_bits(host::adc.end_with(code), kAdcBits, robosim_hal::read_bits);
}

ROBOSIM_FREQUENT void analogWrite(uint8_t pin, int value) {
  host::note_call("analogWrite", pin, 2, pin, value);
  value = robosim_hal::with_bits(value, robosim_hal::write_bits, kPwmBits);
  const host::TimerPin by = host::timer_of(pin);
  const bool by_itself = host::has_pwm_without_timer(pin);
  bool digital = by.timer < 0 && !by_itself;
  if (__builtin_expect(digital || static_cast<unsigned>(value - 1) >= kPwmOn - 1, 0)) {
    const bool full = value == 0 || value == kPwmOn;
    if (!full && robosim_hal::write_bits == kPwmBits)
      host::executor->acted({robosim::FirmwareAction::Kind::analog_write, {pin, value, 0}});
    digital = digital || full;
  }
  host::spend(digital ? cost::kAnalogWriteDigital : cost::kAnalogWrite);
  if (!host::is_digital(pin)) return report_missing(pin, 3);
  const bool was_input = set_mode(pin, OUTPUT);
  if (digital) {
    if (was_input) host::refresh_pin(pin);
    set_level(pin, value == 255 || value >= 128);
    return;
  }
  if (by_itself) return host::set_pwm(pin, robosim::pwm_effect(*host::board_spec, pin, value));
  host::Timer& timer = host::timer(by.timer);
  const uint8_t connection = timer.connection(by.channel);
  if (!(connection & 2)) timer.set_connection(by.channel, connection | 2);
  // An 8-bit register stores only the low byte of the value.
  timer.set_compare(by.channel, timer.is_wide() ? static_cast<uint16_t>(value) : static_cast<uint8_t>(value));
  host::refresh_pin(pin);
}

void shiftOut(uint8_t data_pin, uint8_t clock_pin, uint8_t order, uint8_t value) {
  host::note_call("shiftOut", data_pin, 2, data_pin, clock_pin);
  for (int i = 0; i < 8; ++i) {
    const bool bit = value >> (order == LSBFIRST ? i : 7 - i) & 1;
    host::spend(cost::kShiftOutBit);
    if (!host::is_digital(data_pin) || !host::is_digital(clock_pin)) continue;
    set_level(data_pin, bit);
    set_level(clock_pin, true);
    host::spend(cost::kDigitalWrite);
    set_level(clock_pin, false);
  }
}

uint8_t shiftIn(uint8_t data_pin, uint8_t clock_pin, uint8_t order) {
  host::note_call("shiftIn", data_pin, 2, data_pin, clock_pin);
  uint8_t value = 0;
  for (int i = 0; i < 8; ++i) {
    host::spend(cost::kShiftInBit);
    if (!host::is_digital(data_pin) || !host::is_digital(clock_pin)) continue;
    set_level(clock_pin, true);
    host::spend(cost::kDigitalRead);
    if (get_level(data_pin)) value |= static_cast<uint8_t>(1 << (order == LSBFIRST ? i : 7 - i));
    host::spend(cost::kDigitalWrite);
    set_level(clock_pin, false);
  }
  return value;
}

void robosim_send_pulses(uint8_t pin, const uint8_t* bytes, size_t count, int zero, int one, int period) {
  host::note_call("show", pin, 0);
  if (!host::is_digital(pin)) return;
  for (size_t bit = 0; bit < 8 * count; ++bit) {
    const int high = bytes[bit / 8] >> (7 - bit % 8) & 1 ? one : zero;
    set_level(pin, true);
    host::spend(high);
    set_level(pin, false);
    host::spend(period - high);
  }
}

}  // extern "C"
