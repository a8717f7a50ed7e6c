#include "hal/host/adc.h"

#include "hal/board/board_spec.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host {

Adc adc;

namespace {
constexpr uint8_t kEnable = 0x80, kStart = 0x40, kAuto = 0x20, kFlag = 0x10;
constexpr double kBandgap = 1.1;
}  // namespace

SimTime Adc::clock() const {
  const int exponent = control_ & 7;
  return cycles(exponent == 0 ? 2 : 1 << exponent);
}

SimTime Adc::next_start() const {
  const SimTime past = state.now - clock_began_;
  return clock_began_ + (past + clock() - 1) / clock() * clock();
}

uint16_t Adc::sample() const {
  const BoardSpec& spec = board->spec();
  const int channel = multiplexer_ & 0xF;
  double volts = 0.0;
  if (channel < 8) {
    const int pin = spec.analog_pin_0 + channel;
    if (pin < spec.pin_count) volts = board->read_volts(static_cast<Pin>(pin), state.now);
  } else if (channel == 14) {
    volts = kBandgap;
  }
  return code_of(volts);
}

uint16_t Adc::code_of(double volts) const {
  const double reference = multiplexer_ >> 6 == 3 ? kBandgap : board->spec().supply_volts;
  const double code = volts / reference * 1024.0;
  return code <= 0.0 ? 0 : code >= 1023.0 ? 1023 : static_cast<uint16_t>(code);
}

uint8_t Adc::control() const {
  return static_cast<uint8_t>((control_ & ~kStart) | (converting_ ? kStart : 0));
}

void Adc::start() {
  converting_ = true;
  result_ = sample();
  ready_ = next_start() + 13 * clock();
}

void Adc::set_control(uint8_t value) {
  sync();
  const uint8_t flag = value & kFlag ? 0 : control_ & kFlag;  // writing a one clears it
  if (value & kEnable && !(control_ & kEnable)) clock_began_ = state.now;
  control_ = static_cast<uint8_t>((value & ~(kFlag | kStart)) | flag);
  if (!(value & kEnable)) {
    converting_ = false;
  } else if (value & kStart && !converting_) {
    start();
  }
}

void Adc::sync() {
  if (!converting_ || state.now < ready_) return;
  converting_ = false;
  code_ = result_;
  control_ |= kFlag;
  if (control_ & kAuto && (control_b_ & 7) == 0) start();
}

}  // namespace host
}  // namespace robosim
