#include "sim/exec/stm32/adc.h"

#include <utility>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 11.12
constexpr Address kAdcJofr1 = kAdc1 + 0x14, kAdcHtr = kAdc1 + 0x24, kAdcLtr = kAdc1 + 0x28,
                  kAdcJsqr = kAdc1 + 0x38, kAdcJdr1 = kAdc1 + 0x3C;
constexpr std::uint32_t kAwd = 1u << 0, kJeoc = 1u << 2, kJstrt = 1u << 3;  // ADC_SR
constexpr std::uint32_t kEocie = 1u << 5, kAwdie = 1u << 6, kJeocie = 1u << 7, kScan = 1u << 8,
                        kAwdSgl = 1u << 9, kJauto = 1u << 10, kDiscEn = 1u << 11, kJdiscEn = 1u << 12,
                        kDualMode = 15u << 16, kJawdEn = 1u << 22, kAwdEn = 1u << 23;  // ADC_CR1
constexpr std::uint32_t kCont = 1u << 1, kAdcDma = 1u << 8, kJextTrig = 1u << 15, kJswStart = 1u << 21,
                        kTsVrefE = 1u << 23;  // ADC_CR2
constexpr unsigned kTemperature = 16, kReference = 17, kBySoftware = 7;
constexpr double kTemperatureVolts = 1.43, kReferenceVolts = 1.20;

// 11.12.4, in half cycles of the ADC's clock.
constexpr unsigned kSamplingHalves[] = {3, 15, 27, 57, 83, 111, 143, 479};
constexpr unsigned kConversionHalves = 25;

// Tables 65 and 66
constexpr Signals kRegularTriggers[] = {signal_of(1, 1), signal_of(1, 2), signal_of(1, 3), signal_of(2, 2),
                                        signal_of(3, 0), signal_of(4, 4), kExti11,         0};
constexpr Signals kInjectedTriggers[] = {signal_of(1, 0), signal_of(1, 4), signal_of(2, 0), signal_of(2, 1),
                                         signal_of(3, 4), signal_of(4, 0), kExti15,         0};

}  // namespace

Adc::Adc(Link& link, const Clocks& clocks, SharedLine& line, int index)
    : link_(link), clocks_(clocks), line_(line), index_(index), base_(index == 0 ? kAdc1 : kAdc2) {
  pins_.fill(kNoPin);
  const BoardSpec& spec = link.board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    if (const int channel = spec.pins[pin].analog_channel; channel >= 0 && channel < kStm32f103c8.adc.pins)
      pins_[static_cast<std::size_t>(channel)] = pin;
}

// --- conversions

// One channel unless they are scanned, or taken in turns.
int Adc::regular_length() const {
  return control1_ & (kScan | kDiscEn) ? static_cast<int>(sequence_[0] >> 20 & 15) + 1 : 1;
}

unsigned Adc::channel_of(Group group, int place) const {
  if (group == Group::injected) return injected_sequence_ >> (5 * (place + 4 - injected_length())) & 31;
  return sequence_[static_cast<std::size_t>(2 - place / 6)] >> (5 * (place % 6)) & 31;
}

bool Adc::sequences_are_modelled() const {
  const auto exist = [&](Group group, int length) {
    for (int place = 0; place < length; ++place) {
      const unsigned number = channel_of(group, place);
      if (number >= pins_.size() && number != kTemperature && number != kReference) return false;
    }
    return true;
  };
  return exist(Group::regular, regular_length()) && exist(Group::injected, injected_length());
}

void Adc::begin(Group group, Cycle at) {
  converts_ = group;
  const unsigned number = channel();
  const std::uint32_t times =
      number < 10 ? sample_times_[1] >> (3 * number) : sample_times_[0] >> (3 * (number - 10));
  const unsigned sampling = kSamplingHalves[times & 7];
  const std::uint32_t divider = clocks_.adc_divider();
  sample_at_ = at + sampling * divider / 2;
  done_at_ = at + (sampling + kConversionHalves) * divider / 2;
}

void Adc::start_regular(Cycle at) {
  status_ |= kStrt;
  left_ = control1_ & kDiscEn ? static_cast<int>(control1_ >> 13 & 7) + 1 : regular_length();
  if (!(control1_ & kDiscEn) || regular_at_ >= regular_length()) regular_at_ = 0;
  if (converts_ == Group::injected)
    regular_waits_ = true;
  else
    begin(Group::regular, at);
}

// A regular conversion that it interrupts begins anew behind it (11.3.9).
void Adc::start_injected(Cycle at) {
  if (converts_ == Group::injected) return;
  status_ |= kJstrt;
  regular_waits_ = converts_ == Group::regular;
  begin(Group::injected, at);
}

double Adc::volts(unsigned number) {
  if (number < pins_.size()) return link_.board.read_volts(pins_[number], link_.clock.time());
  if (index_ != 0 || !(control2_ & kTsVrefE)) return 0.0;
  return number == kTemperature ? kTemperatureVolts : kReferenceVolts;
}

void Adc::update() {
  while (link_.clock.now >= next_event()) {
    if (sample_at_ != kNoCycle) {
      sample_at_ = kNoCycle;
      const double code = volts(channel()) / link_.board.spec().supply_volts * 4096.0;
      sampled_ = code <= 0.0 ? 0 : code >= 4095.0 ? 4095 : static_cast<std::uint32_t>(code);
    } else {
      finish();
    }
  }
}

// 11.3.8
void Adc::watch(bool guarded) {
  const bool this_one = !(control1_ & kAwdSgl) || channel() == (control1_ & 31);
  if (guarded && this_one && (sampled_ > high_ || sampled_ < low_)) status_ |= kAwd;
}

void Adc::finish() {
  if (converts_ == Group::injected)
    finish_injected();
  else
    finish_regular();
  refresh_line();
}

void Adc::finish_regular() {
  watch(control1_ & kAwdEn);
  data_ = control2_ & kAlign ? sampled_ << 4 : sampled_;
  dma_asks_ = control2_ & kAdcDma;
  const bool last = ++regular_at_ >= regular_length();
  if (last) {
    status_ |= kEoc;
    regular_at_ = 0;
  }
  converts_ = Group::none;
  const Cycle at = done_at_;
  if (--left_ > 0 && !last) return begin(Group::regular, at);
  if (last && control1_ & kJauto) {
    start_injected(at);
    regular_waits_ = control2_ & kCont;
  } else if (last && control2_ & kCont) {
    start_regular(at);
  }
}

// 11.12.12: a result is signed, for an offset is taken from it.
void Adc::finish_injected() {
  watch(control1_ & kJawdEn);
  const auto place = static_cast<std::size_t>(injected_at_);
  const std::uint32_t value = sampled_ - offsets_[place];
  injected_data_[place] = (control2_ & kAlign ? value << 3 : value) & 0xFFFF;
  const bool last = ++injected_at_ >= injected_length();
  if (last) {
    status_ |= kJeoc;
    injected_at_ = 0;
  }
  converts_ = Group::none;
  const Cycle at = done_at_;
  if (!last && !(control1_ & kJdiscEn)) return begin(Group::injected, at);
  if (!std::exchange(regular_waits_, false)) return;
  if (left_ > 0)
    begin(Group::regular, at);
  else
    start_regular(at);
}

// --- triggers

Signals Adc::listens() const {
  Signals signals = 0;
  if (!(control2_ & kAdOn)) return signals;
  if (control2_ & kExtTrig) signals |= kRegularTriggers[control2_ >> 17 & 7];
  if (control2_ & kJextTrig) signals |= kInjectedTriggers[control2_ >> 12 & 7];
  return signals;
}

void Adc::heard(Signals signal) {
  update();
  if (control2_ & kJextTrig && signal & kInjectedTriggers[control2_ >> 12 & 7])
    start_injected(link_.clock.now);
  if (control2_ & kExtTrig && signal & kRegularTriggers[control2_ >> 17 & 7]) start_regular(link_.clock.now);
}

// RM0008 table 78: ADC2 has none.
unsigned Adc::dma_requests() const { return dma_asks_ && index_ == 0 ? dma_channel(1) : 0; }

// --- registers

void Adc::refresh_line() {
  line_.set(index_, (status_ & kEoc && control1_ & kEocie) || (status_ & kJeoc && control1_ & kJeocie) ||
                        (status_ & kAwd && control1_ & kAwdie));
}

void Adc::reset(Address) {
  static_cast<AdcRegisters&>(*this) = {};
  refresh_line();
}

std::uint32_t Adc::read(Address address) {
  if (link_.clock.now >= next_event()) update();
  address = address - base_ + kAdc1;
  const auto place = [&](Address first) { return static_cast<std::size_t>((address - first) / 4); };
  if (address >= kAdcJofr1 && address < kAdcHtr) return offsets_[place(kAdcJofr1)];
  if (address >= kAdcJdr1 && address < kAdcDr) return injected_data_[place(kAdcJdr1)];
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
    case kAdcHtr:
      return high_;
    case kAdcLtr:
      return low_;
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      return sequence_[place(kAdcSqr1)];
    case kAdcJsqr:
      return injected_sequence_;
    case kAdcDr:
      status_ &= ~kEoc;
      dma_asks_ = false;
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

bool Adc::write_control2(std::uint32_t value) {
  const bool was_on = control2_ & kAdOn;
  const bool other_bits_same = ((control2_ ^ value) & ~(kSwStart | kJswStart)) == 0;
  // Calibration is over at once.
  control2_ = value & ~(kCal | kRstCal | kSwStart | kJswStart);
  if (!(value & kAdOn)) {
    converts_ = Group::none;
    regular_at_ = injected_at_ = 0;
    return true;
  }
  const bool regular = value & kExtTrig && (value >> 17 & 7) == kBySoftware && value & kSwStart;
  const bool injected = value & kJextTrig && (value >> 12 & 7) == kBySoftware && value & kJswStart;
  const bool by_adon = other_bits_same && !(value & (kSwStart | kJswStart));
  if (!was_on) return true;
  if (regular || by_adon) start_regular(link_.clock.now);
  if (injected) start_injected(link_.clock.now);
  return sequences_are_modelled();
}

bool Adc::write_register(Address address, std::uint32_t value) {
  const auto place = [&](Address first) { return static_cast<std::size_t>((address - first) / 4); };
  if (address >= kAdcJofr1 && address < kAdcHtr) return offsets_[place(kAdcJofr1)] = value & 0xFFF, true;
  switch (address) {
    case kAdcSr:
      status_ &= value;
      return true;
    case kAdcCr1:
      control1_ = value;
      return (value & kDualMode) == 0;
    case kAdcCr2:
      return write_control2(value);
    case kAdcSmpr1:
      sample_times_[0] = value;
      return true;
    case kAdcSmpr2:
      sample_times_[1] = value;
      return true;
    case kAdcHtr:
      high_ = value & 0xFFF;
      return true;
    case kAdcLtr:
      low_ = value & 0xFFF;
      return true;
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      sequence_[place(kAdcSqr1)] = value;
      return true;
    case kAdcJsqr:
      injected_sequence_ = value;
      return true;
    default:
      return true;
  }
}

}  // namespace robosim::exec::stm32
