#include "sim/exec/stm32/adc.h"

#include <utility>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Register addresses and bits (RM0008 11.12).
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

// Sampling times (11.12.4), in half cycles of the ADC's clock.
constexpr unsigned kSamplingHalves[] = {3, 15, 27, 57, 83, 111, 143, 479};
constexpr unsigned kConversionHalves = 25;

// Trigger signals by EXTSEL and JEXTSEL (tables 65 and 66).
constexpr Signals kRegularTriggers[] = {signal_of(1, 1), signal_of(1, 2), signal_of(1, 3), signal_of(2, 2),
                                        signal_of(3, 0), signal_of(4, 4), kExti11,         0};
constexpr Signals kInjectedTriggers[] = {signal_of(1, 0), signal_of(1, 4), signal_of(2, 0), signal_of(2, 1),
                                         signal_of(3, 4), signal_of(4, 0), kExti15,         0};

}  // namespace

Adc::Adc(Link& link, const Clocks& clocks, SharedLine& line, int index)
    : link_(link), clocks_(clocks), line_(line), index_(index), base_(index == 0 ? kAdc1 : kAdc2) {
  link.snapshots.add(state_);
  pins_.fill(kNoPin);
  const BoardSpec& spec = link.board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    if (const int channel = spec.pins[pin].analog_channel; channel >= 0 && channel < kStm32f103c8.adc.pins)
      pins_[static_cast<std::size_t>(channel)] = pin;
}

// --- conversions

// Returns the length of the regular sequence in scan or discontinuous mode; otherwise 1.
int Adc::regular_length() const {
  return state_.control1 & (kScan | kDiscEn) ? static_cast<int>(state_.sequence[0] >> 20 & 15) + 1 : 1;
}

unsigned Adc::channel_of(Group group, int place) const {
  if (group == Group::injected) return state_.injected_sequence >> (5 * (place + 4 - injected_length())) & 31;
  return state_.sequence[static_cast<std::size_t>(2 - place / 6)] >> (5 * (place % 6)) & 31;
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
  state_.converts = group;
  const unsigned number = channel();
  const std::uint32_t times =
      number < 10 ? state_.sample_times[1] >> (3 * number) : state_.sample_times[0] >> (3 * (number - 10));
  const unsigned sampling = kSamplingHalves[times & 7];
  const std::uint32_t divider = clocks_.adc_divider();
  state_.sample_at = at + sampling * divider / 2;
  state_.done_at = at + (sampling + kConversionHalves) * divider / 2;
}

void Adc::start_regular(Cycle at) {
  link_.note_read(InputReads::kAnalog);
  state_.status |= kStrt;
  state_.left =
      state_.control1 & kDiscEn ? static_cast<int>(state_.control1 >> 13 & 7) + 1 : regular_length();
  if (!(state_.control1 & kDiscEn) || state_.regular_at >= regular_length()) state_.regular_at = 0;
  if (state_.converts == Group::injected)
    state_.regular_waits = true;
  else
    begin(Group::regular, at);
}

// Starts the injected group. This interrupts a running regular conversion, which later restarts (11.3.9).
void Adc::start_injected(Cycle at) {
  if (state_.converts == Group::injected) return;
  state_.status |= kJstrt;
  state_.regular_waits = state_.converts == Group::regular;
  begin(Group::injected, at);
}

double Adc::volts(unsigned number) {
  if (number < pins_.size()) return link_.board.read_volts(pins_[number], link_.clock.time());
  if (index_ != 0 || !(state_.control2 & kTsVrefE)) return 0.0;
  return number == kTemperature ? kTemperatureVolts : kReferenceVolts;
}

void Adc::update() {
  while (link_.clock.now >= next_event()) {
    if (state_.sample_at != kNoCycle) {
      state_.sample_at = kNoCycle;
      const double code = volts(channel()) / link_.board.supply_volts() * 4096.0;
      state_.sampled = code <= 0.0 ? 0 : code >= 4095.0 ? 4095 : static_cast<std::uint32_t>(code);
    } else {
      finish();
    }
  }
}

// Compares the result of a conversion with the limits of the analog watchdog (11.3.8).
void Adc::watch(bool guarded) {
  const bool this_one = !(state_.control1 & kAwdSgl) || channel() == (state_.control1 & 31);
  if (guarded && this_one && (state_.sampled > state_.high || state_.sampled < state_.low))
    state_.status |= kAwd;
}

void Adc::finish() {
  if (state_.converts == Group::injected)
    finish_injected();
  else
    finish_regular();
  refresh_line();
}

void Adc::finish_regular() {
  watch(state_.control1 & kAwdEn);
  state_.data = state_.control2 & kAlign ? state_.sampled << 4 : state_.sampled;
  state_.dma_asks = state_.control2 & kAdcDma;
  const bool last = ++state_.regular_at >= regular_length();
  if (last) {
    state_.status |= kEoc;
    state_.regular_at = 0;
  }
  state_.converts = Group::none;
  const Cycle at = state_.done_at;
  if (--state_.left > 0 && !last) return begin(Group::regular, at);
  if (last && state_.control1 & kJauto) {
    start_injected(at);
    state_.regular_waits = state_.control2 & kCont;
  } else if (last && state_.control2 & kCont) {
    start_regular(at);
  }
}

// Stores a signed result, because an offset is subtracted from each injected conversion (11.12.12).
void Adc::finish_injected() {
  watch(state_.control1 & kJawdEn);
  const auto place = static_cast<std::size_t>(state_.injected_at);
  const std::uint32_t value = state_.sampled - state_.offsets[place];
  state_.injected_data[place] = (state_.control2 & kAlign ? value << 3 : value) & 0xFFFF;
  const bool last = ++state_.injected_at >= injected_length();
  if (last) {
    state_.status |= kJeoc;
    state_.injected_at = 0;
  }
  state_.converts = Group::none;
  const Cycle at = state_.done_at;
  if (!last && !(state_.control1 & kJdiscEn)) return begin(Group::injected, at);
  if (!std::exchange(state_.regular_waits, false)) return;
  if (state_.left > 0)
    begin(Group::regular, at);
  else
    start_regular(at);
}

// --- triggers

Signals Adc::listens() const {
  Signals signals = 0;
  if (!(state_.control2 & kAdOn)) return signals;
  if (state_.control2 & kExtTrig) signals |= kRegularTriggers[state_.control2 >> 17 & 7];
  if (state_.control2 & kJextTrig) signals |= kInjectedTriggers[state_.control2 >> 12 & 7];
  return signals;
}

void Adc::heard(Signals signal) {
  update();
  if (state_.control2 & kJextTrig && signal & kInjectedTriggers[state_.control2 >> 12 & 7])
    start_injected(link_.clock.now);
  if (state_.control2 & kExtTrig && signal & kRegularTriggers[state_.control2 >> 17 & 7])
    start_regular(link_.clock.now);
}

// ADC2 has no DMA requests (RM0008, table 78).
unsigned Adc::dma_requests() const { return state_.dma_asks && index_ == 0 ? dma_channel(1) : 0; }

// --- registers

void Adc::refresh_line() {
  line_.set(index_, (state_.status & kEoc && state_.control1 & kEocie) ||
                        (state_.status & kJeoc && state_.control1 & kJeocie) ||
                        (state_.status & kAwd && state_.control1 & kAwdie));
}

void Adc::reset(Address) {
  state_ = {};
  refresh_line();
}

std::uint32_t Adc::read(Address address) {
  if (link_.clock.now >= next_event()) update();
  address = address - base_ + kAdc1;
  const auto place = [&](Address first) { return static_cast<std::size_t>((address - first) / 4); };
  if (address >= kAdcJofr1 && address < kAdcHtr) return state_.offsets[place(kAdcJofr1)];
  if (address >= kAdcJdr1 && address < kAdcDr) return state_.injected_data[place(kAdcJdr1)];
  switch (address) {
    case kAdcSr:
      return state_.status;
    case kAdcCr1:
      return state_.control1;
    case kAdcCr2:
      return state_.control2;
    case kAdcSmpr1:
      return state_.sample_times[0];
    case kAdcSmpr2:
      return state_.sample_times[1];
    case kAdcHtr:
      return state_.high;
    case kAdcLtr:
      return state_.low;
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      return state_.sequence[place(kAdcSqr1)];
    case kAdcJsqr:
      return state_.injected_sequence;
    case kAdcDr:
      state_.status &= ~kEoc;
      state_.dma_asks = false;
      refresh_line();
      return state_.data;
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
  const bool was_on = state_.control2 & kAdOn;
  const bool other_bits_same = ((state_.control2 ^ value) & ~(kSwStart | kJswStart)) == 0;
  // Calibration takes no time.
  state_.control2 = value & ~(kCal | kRstCal | kSwStart | kJswStart);
  if (!(value & kAdOn)) {
    state_.converts = Group::none;
    state_.regular_at = state_.injected_at = 0;
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
  if (address >= kAdcJofr1 && address < kAdcHtr)
    return state_.offsets[place(kAdcJofr1)] = value & 0xFFF, true;
  switch (address) {
    case kAdcSr:
      state_.status &= value;
      return true;
    case kAdcCr1:
      state_.control1 = value;
      return (value & kDualMode) == 0;
    case kAdcCr2:
      return write_control2(value);
    case kAdcSmpr1:
      state_.sample_times[0] = value;
      return true;
    case kAdcSmpr2:
      state_.sample_times[1] = value;
      return true;
    case kAdcHtr:
      state_.high = value & 0xFFF;
      return true;
    case kAdcLtr:
      state_.low = value & 0xFFF;
      return true;
    case kAdcSqr1:
    case kAdcSqr2:
    case kAdcSqr3:
      state_.sequence[place(kAdcSqr1)] = value;
      return true;
    case kAdcJsqr:
      state_.injected_sequence = value;
      return true;
    default:
      return true;
  }
}

}  // namespace robosim::exec::stm32
