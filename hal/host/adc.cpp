#include "hal/host/adc.h"

#include "hal/board/board_spec.h"
#include "hal/host/other_registers.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {

Adc adc;

uint16_t Adc::data() const { return avr::adc_data(multiplexer_, code_); }

void Adc::set_multiplexer(uint8_t value) {
  const int before = avr::adc_selection(kChip.adc, multiplexer_, 0);
  if (avr::adc_selection(kChip.adc, value, 0) != before) charge();
  multiplexer_ = value;
}

uint16_t Adc::sample(SimTime late) {
  const auto wired = [](int channel) { return places[board_spec->analog_pin_0 + channel].wired; };
  const auto source = [&](int channel) {
    return channel < board_spec->pin_count - board_spec->analog_pin_0
               ? board->read_source(wired(channel), state.now)
               : Source();
  };
  const auto report = [&](int channel) {
    executor->acted({FirmwareAction::Kind::conversion,
                     {wired(channel), static_cast<int64_t>(1e9 * capacitor_.error), 0}});
  };
  const auto seconds = [&] { return 1e-9 * static_cast<double>(state.now + late - charges_since_); };
  return avr::adc_sample(kChip.adc, multiplexer_, 0, *supply_volts, seconds, capacitor_, source, report);
}

uint16_t Adc::code_of(double volts) const {
  return avr::adc_code(volts, avr::adc_reference_volts(kChip.adc, multiplexer_, *supply_volts));
}

uint8_t Adc::control() const { return static_cast<uint8_t>((control_ & ~kAdsc) | (converting_ ? kAdsc : 0)); }

void Adc::start(SimTime at) {
  converting_ = true;
  const bool first = take_first(false);
  result_ = sample(at + avr::adc_half_clocks_to_sample(first) * clock() / 2 - state.now);
  ready_ = at + avr::adc_clocks(first) * clock();
}

void Adc::set_control_b(uint8_t value) {
  control_b_ = value;
  look_for_trigger();
}

void Adc::look_for_trigger() const {
  if (control_ & kAdate && control_b_ & kAdts) note_lack("conversions started by ADTS");
}

void Adc::set_control(uint8_t value) {
  sync();
  const uint8_t flag = value & kAdif ? 0 : control_ & kAdif;  // writing a one clears the flag
  if (value & kAden && !(control_ & kAden)) {
    clock_began_ = charges_since_ = state.now;
    first_ = First::by_sketch;
  }
  control_ = static_cast<uint8_t>((value & ~(kAdif | kAdsc)) | flag);
  look_for_trigger();
  if (!(value & kAden)) {
    converting_ = false;
  } else if (value & kAdsc && !converting_) {
    start(next_start());
  }
}

void Adc::sync_conversion() {
  while (converting_ && state.now >= ready_) {
    converting_ = false;
    charges_since_ = ready_;
    if (!locked_) code_ = result_;
    control_ |= kAdif;
    if (!(control_ & kAdate) || control_b_ & kAdts) return;
    // Free running: skips all conversions except the last one that has ended, and the present one.
    const SimTime takes = avr::adc_clocks(false) * clock(), ended = (state.now - ready_) / takes;
    start(ready_ + (ended > 1 ? ended - 1 : 0) * takes);
  }
}

}  // namespace host
}  // namespace robosim
