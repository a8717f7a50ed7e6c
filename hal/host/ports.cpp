#include "hal/host/ports.h"

#include "hal/host/clock.h"
#include "hal/host/timers.h"

namespace robosim {
namespace host {

PortRegisters ports[kPorts];

namespace {

PinDrive driven[kMostPins];
uint32_t tone_hz[kMostPins];

PinDrive drive_of(Pin pin) {
  const PortRegisters& port = ports[port_of(pin)];
  const uint8_t mask = mask_of(pin);
  PinDrive drive;
  if (!(port.direction & mask)) {
    drive.mode = port.output & mask ? PinMode::input_pullup : PinMode::input;
    return drive;
  }
  const TimerPin by = timer_of(pin);
  if (by.timer >= 0 && timer(by.timer).connection(by.channel)) return timer(by.timer).drive(by.channel);
  drive.mode = PinMode::output;
  if (tone_hz[pin]) {
    drive.pwm = true;
    drive.duty = 0.5;
    drive.tone_hz = tone_hz[pin];
  } else {
    drive.level = port.output & mask;
    drive.duty = drive.level ? 1.0 : 0.0;
  }
  return drive;
}

void refresh_port(Port port, uint8_t changed) {
  for (int bit = 0; bit < kPortBits[port].count; ++bit)
    if (changed >> bit & 1) refresh_pin(static_cast<Pin>(kPortBits[port].first + bit));
}

}  // namespace

void refresh_pin(Pin pin) {
  const PinDrive drive = drive_of(pin);
  if (drive == driven[pin]) return;
  driven[pin] = drive;
  board->set_drive(pin, drive, state.now);
}

void refresh_timer_pins(int number) {
  static const Pin kPins[3][2] = {{6, 5}, {9, 10}, {11, 3}};
  for (const Pin pin : kPins[number]) refresh_pin(pin);
}

void set_direction(Port port, uint8_t value) {
  const uint8_t changed = ports[port].direction ^ value;
  ports[port].direction = value;
  refresh_port(port, changed);
}

void set_output(Port port, uint8_t value) {
  const uint8_t changed = ports[port].output ^ value;
  ports[port].output = value;
  refresh_port(port, changed);
}

uint8_t read_port(Port port) {
  uint8_t value = 0;
  for (int bit = 0; bit < kPortBits[port].count; ++bit)
    if (board->read_level(static_cast<Pin>(kPortBits[port].first + bit), state.now))
      value |= static_cast<uint8_t>(1 << bit);
  return value;
}

void set_tone(Pin pin, uint32_t hz) {
  tone_hz[pin] = hz;
  refresh_pin(pin);
}

void reset_ports() {
  for (PortRegisters& port : ports) port = PortRegisters();
  for (Pin pin = 0; pin < kMostPins; ++pin) {
    driven[pin] = PinDrive();
    tone_hz[pin] = 0;
  }
}

}  // namespace host
}  // namespace robosim
