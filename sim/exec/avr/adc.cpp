#include "sim/exec/avr/adc.h"

namespace robosim::exec::avr {
namespace {

constexpr double kBandgap_volts = 1.1;
constexpr std::uint8_t kLeftAdjusted = 0x20;

}  // namespace

Adc::Adc(Link& link) : link_(link), module_(link.chip.find_module<avr_adc_t>("adc")) {
  avr_irq_register_notify(module_->io.irq + ADC_IRQ_OUT_TRIGGER, &Adc::on_start, this);
}

void Adc::on_start(avr_irq_t*, std::uint32_t, void* self) {
  auto& adc = *static_cast<Adc*>(self);
  adc.finish();
  Chip& chip = adc.link_.chip;
  const int exponent = std::max(chip.data(reg::kAdcsra) & 7, 1);
  const Cycle clock = Cycle{1} << exponent;
  adc.multiplexer_ = chip.data(reg::kAdmux);
  adc.converting_ = true;
  adc.done_at_ = chip.cycle() + (adc.module_->first ? 25 : 13) * clock;
  avr_cycle_timer_register(chip.simavr(), (adc.module_->first ? 12 : 0) * clock + clock + clock / 2,
                           &Adc::on_sample, self);
}

avr_cycle_count_t Adc::on_sample(avr_t*, avr_cycle_count_t, void* self) {
  auto& adc = *static_cast<Adc*>(self);
  adc.sampled_ = adc.sample();
  return 0;
}

std::uint16_t Adc::sample() const {
  const BoardSpec& spec = link_.board.spec();
  const double reference = multiplexer_ >> 6 == 3 ? kBandgap_volts : spec.supply_volts;
  const int channel = multiplexer_ & 0xF;
  double volts = 0.0;
  if (channel < 8) {
    const int pin = spec.analog_pin_0 + channel;
    if (pin < spec.pin_count) volts = link_.board.read_volts(static_cast<Pin>(pin), link_.now());
  } else if (channel == 14) {
    volts = kBandgap_volts;
  }
  const double code = volts / reference * 1024.0;
  return code <= 0.0 ? 0 : code >= 1023.0 ? 1023 : static_cast<std::uint16_t>(code);
}

void Adc::finish() {
  if (!converting_ || link_.chip.cycle() < done_at_) return;
  converting_ = false;
  if (!locked_) result_ = sampled_;
}

std::uint8_t Adc::read(reg::Address address) {
  finish();
  locked_ = address == reg::kAdcL;
  const int code = link_.chip.data(reg::kAdmux) & kLeftAdjusted ? result_ << 6 : result_;
  return static_cast<std::uint8_t>(address == reg::kAdcL ? code : code >> 8);
}

void Adc::was_reset() {
  converting_ = locked_ = false;
  result_ = 0;
}

}  // namespace robosim::exec::avr
