#include "sim/exec/avr/adc.h"

#include "hal/board/avr_adc_sample.h"

namespace robosim::exec::avr {
Adc::Adc(Link& link) : link_(link), module_(link.chip.find_module<avr_adc_t>("adc")) {
  avr_irq_register_notify(module_->io.irq + ADC_IRQ_OUT_TRIGGER, &Adc::on_start, this);
}

void Adc::on_start(avr_irq_t*, std::uint32_t, void* self) {
  auto& adc = *static_cast<Adc*>(self);
  adc.finish();
  Chip& chip = adc.link_.chip;
  const bool first = adc.module_->first;
  const auto clock = static_cast<Cycle>(robosim::avr::adc_prescaler(chip.data(reg::kAdcsra)));
  adc.multiplexer_ = chip.data(reg::kAdmux);
  adc.converting_ = true;
  adc.done_at_ = chip.cycle() + static_cast<Cycle>(robosim::avr::adc_clocks(first)) * clock;
  const auto half_clocks = static_cast<Cycle>(robosim::avr::adc_half_clocks_to_sample(first));
  avr_cycle_timer_register(chip.simavr(), half_clocks * clock / 2, &Adc::on_sample, self);
}

avr_cycle_count_t Adc::on_sample(avr_t*, avr_cycle_count_t, void* self) {
  auto& adc = *static_cast<Adc*>(self);
  adc.sampled_ =
      robosim::avr::adc_sample(adc.link_.board, adc.link_.chip.spec().adc, adc.multiplexer_, adc.link_.now());
  return 0;
}

void Adc::finish() {
  if (!converting_ || link_.chip.cycle() < done_at_) return;
  converting_ = false;
  if (!locked_) result_ = sampled_;
}

std::uint8_t Adc::read(reg::Address address) {
  finish();
  locked_ = address == reg::kAdcL;
  const int code = robosim::avr::adc_data(link_.chip.data(reg::kAdmux), result_);
  return static_cast<std::uint8_t>(address == reg::kAdcL ? code : code >> 8);
}

void Adc::was_reset() {
  converting_ = locked_ = false;
  result_ = 0;
}

}  // namespace robosim::exec::avr
