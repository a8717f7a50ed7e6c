#include "sim/exec/stm32/adc.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 11.12.4, in half cycles of the ADC's clock.
constexpr unsigned kSamplingHalves[] = {3, 15, 27, 57, 83, 111, 143, 479};
constexpr unsigned kConversionHalves = 25;

}  // namespace

Adc::Adc(Link& link, const Clocks& clocks, SharedLine& line, int index)
    : link_(link), clocks_(clocks), line_(line), index_(index), base_(index == 0 ? kAdc1 : kAdc2) {
  pins_.fill(kNoPin);
  const BoardSpec& spec = link.board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    if (const int channel = spec.pins[pin].analog_channel; channel >= 0 && channel < kStm32f103c8.adc.pins)
      pins_[static_cast<std::size_t>(channel)] = pin;
}

void Adc::update() {
  if (link_.clock.now >= sample_at_) {
    sample_at_ = kNoCycle;
    const BoardSpec& spec = link_.board.spec();
    const double volts =
        link_.board.read_volts(pins_[static_cast<std::size_t>(channel())], link_.clock.time());
    const double code = volts / spec.supply_volts * 4096.0;
    sampled_ = code <= 0.0 ? 0 : code >= 4095.0 ? 4095 : static_cast<std::uint32_t>(code);
  }
  if (converts_ && sample_at_ == kNoCycle && link_.clock.now >= done_at_) {
    converts_ = false;
    data_ = control2_ & kAlign ? sampled_ << 4 : sampled_;
    status_ |= kEoc;
    refresh_line();
  }
}

bool Adc::start() {
  const auto number = static_cast<unsigned>(channel());
  if (number >= pins_.size() || sequence_[0] >> 20 & 15) return false;
  const unsigned sampling = kSamplingHalves[sample_times_[1] >> (3 * number) & 7];
  const std::uint32_t divider = clocks_.adc_divider();
  sample_at_ = link_.clock.now + sampling * divider / 2;
  done_at_ = link_.clock.now + (sampling + kConversionHalves) * divider / 2;
  converts_ = true;
  status_ |= kStrt;
  return true;
}

void Adc::reset(Address) {
  static_cast<AdcRegisters&>(*this) = {};
  refresh_line();
}

std::uint32_t Adc::read(Address address) {
  update();
  address = address - base_ + kAdc1;
  switch (address) {
    case kAdcSr:
      return status_;
    case kAdcCr1:
      return control1_;
    case kAdcCr2:
      return control2_;
    case kAdcSmpr1:
      return sample_times_[0];
    case kAdcSmpr2:
      return sample_times_[1];
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      return sequence_[(address - kAdcSqr1) / 4];
    case kAdcDr:
      status_ &= ~kEoc;
      refresh_line();
      return data_;
    default:
      return 0;
  }
}

bool Adc::write(Address address, std::uint32_t value) {
  update();
  const bool modelled = write_register(address - base_ + kAdc1, value);
  refresh_line();
  return modelled;
}

bool Adc::write_register(Address address, std::uint32_t value) {
  switch (address) {
    case kAdcSr:
      status_ &= value;
      return true;
    case kAdcCr1:
      control1_ = value;
      return (value & ~kEocie) == 0;
    case kAdcCr2: {
      const bool was_on = control2_ & kAdOn;
      const bool other_bits_same = ((control2_ ^ value) & ~kSwStart) == 0;
      // Calibration is over at once.
      control2_ = value & ~(kCal | kRstCal | kSwStart);
      if ((value & ~(kAdOn | kCal | kRstCal | kAlign | kExtSelSw | kExtTrig | kSwStart)) != 0) return false;
      const bool by_software = value & kSwStart && value & kExtTrig && (value & kExtSelSw) == kExtSelSw;
      const bool by_adon = value & kAdOn && other_bits_same && !(value & kSwStart);
      if (was_on && (by_software || by_adon)) return start();
      return true;
    }
    case kAdcSmpr1:
      sample_times_[0] = value;
      return true;
    case kAdcSmpr2:
      sample_times_[1] = value;
      return true;
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      sequence_[(address - kAdcSqr1) / 4] = value;
      return true;
    default:
      return value == 0;
  }
}

}  // namespace robosim::exec::stm32
