#include "sim/mcu/avr/adc.h"

#include "hal/board/avr_adc.h"

namespace robosim::avr {
namespace {

constexpr Cycle kAutoTriggerCycles = 3;

}  // namespace

Adc::Adc(Core& core, Pins& pins) : core_(core), at_(core.chip.at), pins_(pins) {
  core.cpu.on_read<&Adc::read_control>(at_.adc_control, this);
  core.cpu.on_write<&Adc::write_control>(at_.adc_control, this);
  core.cpu.on_write_bit<&Adc::write_control_bit>(at_.adc_control, this);
  core.cpu.on_read<&Adc::read_plain>(at_.adc_control_b, this);
  core.cpu.on_write<&Adc::write_control_b>(at_.adc_control_b, this);
  core.cpu.on_read<&Adc::read_plain>(at_.adc_multiplexer, this);
  core.cpu.on_write<&Adc::write_multiplexer>(at_.adc_multiplexer, this);
  for (const Address address : {at_.adc_control, at_.adc_control_b, at_.adc_multiplexer})
    core.cpu.is_steady(address);
  core.cpu.on_read<&Adc::read_data>(at_.adc_data, this);
  core.cpu.on_read<&Adc::read_data>(static_cast<Address>(at_.adc_data + 1), this);
  core.interrupts.on_entry<&Adc::entered>(core.chip.adc.vector, this);
  core.triggers.on_trigger<&Adc::triggered>(this);
  sample_ = core.events.add<&Adc::sample>(this);
  end_ = core.events.add<&Adc::end>(this);
  core.keep(state_);
}

void Adc::reset(Cycle) {
  state_ = {};
  core_.triggers.await(AdcTriggers::kNone);
}

Cycle Adc::clock() const { return static_cast<Cycle>(adc_prescaler(core_.cpu.data[at_.adc_control])); }

Cycle Adc::edge_after(Cycle cycle) const {
  const Cycle first = state_.origin + clock() / 2;
  // The mask rounds down to a multiple of clock(), which is a power of two.
  return cycle < first ? first : first + ((cycle - first) & ~(clock() - 1)) + clock();
}

int Adc::trigger() const {
  const std::uint8_t control = core_.cpu.data[at_.adc_control];
  if (!(control & kAden) || !(control & kAdate)) return AdcTriggers::kNone;
  return core_.chip.adc.triggers[core_.cpu.data[at_.adc_control_b] & kAdts];
}

std::uint64_t Adc::may_interrupt() const {
  const bool comes = state_.converting || trigger() != AdcTriggers::kNone;
  return Interrupts::bit(core_.chip.adc.vector, comes && core_.cpu.data[at_.adc_control] & kAdie);
}

void Adc::request() {
  const std::uint8_t control = core_.at(at_.adc_control);
  core_.request(core_.chip.adc.vector, control & kAdif && control & kAdie);
}

void Adc::entered(int) {
  core_.at(at_.adc_control) &= static_cast<std::uint8_t>(~kAdif);
  request();
}

std::uint8_t Adc::read_control(Address address) {
  if (!state_.runs) return 0;
  return static_cast<std::uint8_t>(core_.at(address) | (state_.converting ? kAdsc : 0));
}

std::uint8_t Adc::read_plain(Address address) { return state_.runs ? core_.at(address) : std::uint8_t{0}; }

std::uint8_t Adc::read_data(Address address) {
  if (!state_.runs) return 0;
  state_.locked = address == at_.adc_data;
  const std::uint16_t data = adc_data(core_.at(at_.adc_multiplexer), state_.result);
  return static_cast<std::uint8_t>(address == at_.adc_data ? data : data >> 8);
}

void Adc::write_control(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  const std::uint8_t before = core_.at(address);
  const auto flag = static_cast<std::uint8_t>(value & kAdif ? 0 : before & kAdif);
  core_.at(address) = static_cast<std::uint8_t>((value & ~(kAdif | kAdsc)) | flag);
  if (!(value & kAden)) {
    abort();
  } else {
    if (!(before & kAden)) {
      state_.origin = state_.charges_since = core_.now();
      state_.first = true;
    }
    if (value & kAdsc && !state_.converting) {
      pins_.note_conversion();
      start(edge_after(core_.now()));
    }
  }
  core_.triggers.await(trigger());
  request();
}

// Handles SBI and CBI, which can address ADCSRA on an ATtiny85. If SBI or CBI changes another bit, ADIF
// is not cleared (ATtiny85 data sheet 2586Q, notes on the register summary).
void Adc::write_control_bit(Address address, std::uint8_t value, std::uint8_t bit) {
  write_control(address, bit == kAdif ? value : static_cast<std::uint8_t>(value & ~kAdif));
}

// Handles a change of the trigger source (24.4). The flag of the selected source drives the trigger signal. A
// rising edge of this signal starts a conversion, even if the change of source causes the edge.
void Adc::write_control_b(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  const int before = trigger();
  const bool was_set =
      before == AdcTriggers::kNone ? (core_.at(at_.adc_control) & kAdif) != 0 : core_.triggers.await(before);
  selects_another(core_.at(at_.adc_multiplexer), value & core_.chip.adc.control_b_bits);
  core_.at(address) = value & core_.chip.adc.control_b_bits;
  if (state_.converting && core_.now() < state_.start) select();
  const int now = trigger();
  const bool is_set = core_.triggers.await(now);
  if (now != AdcTriggers::kNone && is_set && !was_set) triggered(core_.now());
}

void Adc::write_multiplexer(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  selects_another(value, core_.at(at_.adc_control_b));
  core_.at(address) =
      value & (kRefs | kAdlar | core_.chip.adc.reference_bit | core_.chip.adc.multiplexer_bits);
  if (state_.converting && core_.now() < state_.start) select();
}

// Restarts the charging time of the sampling capacitor if another input is selected.
void Adc::selects_another(std::uint8_t multiplexer, std::uint8_t control_b) {
  const auto now = adc_selection(core_.chip.adc, core_.at(at_.adc_multiplexer), core_.at(at_.adc_control_b));
  if (adc_selection(core_.chip.adc, multiplexer, control_b) != now) state_.charges_since = core_.now();
}

void Adc::select() {
  state_.multiplexer = core_.at(at_.adc_multiplexer);
  state_.control_b = core_.at(at_.adc_control_b);
}

void Adc::triggered(Cycle at) {
  if (state_.converting || !state_.runs) return;
  state_.origin = at + kAutoTriggerCycles;
  start(edge_after(state_.origin));
}

void Adc::start(Cycle edge) {
  state_.converting = true;
  state_.start = edge;
  select();
  const bool first = state_.first;
  state_.first = false;
  core_.schedule(sample_, edge + static_cast<Cycle>(adc_half_clocks_to_sample(first)) * clock() / 2);
  core_.schedule(end_, edge + static_cast<Cycle>(adc_clocks(first)) * clock());
}

void Adc::sample(Cycle at) {
  const auto seconds = [&] {
    const auto cycles = static_cast<std::int64_t>(at - state_.charges_since);
    return static_cast<double>(cycles) / static_cast<double>(core_.clock_hz);
  };
  state_.sampled = adc_sample(
      core_.chip.adc, state_.multiplexer, state_.control_b, core_.environment.supply_volts(), seconds,
      state_.capacitor, [&](int channel) { return pins_.source(pins_.analog(channel), at); },
      [&](int channel) {
        if (core_.on_conversion)
          core_.on_conversion(core_.on_conversion_self, pins_.analog(channel), state_.capacitor.error);
      });
}

void Adc::end(Cycle at) {
  state_.converting = false;
  state_.charges_since = at;
  if (!state_.locked) state_.result = state_.sampled;
  std::uint8_t& control = core_.at(at_.adc_control);
  control |= kAdif;
  request();
  if (control & kAdate && trigger() == AdcTriggers::kNone) start(at);
}

void Adc::abort() {
  state_.converting = false;
  core_.events.cancel(sample_);
  core_.events.cancel(end_);
}

void Adc::falls_asleep(bool adc_clock_runs, Cycle at) {
  const std::uint8_t control = core_.at(at_.adc_control);
  if (!adc_clock_runs || !state_.runs || state_.converting || !(control & kAden) || control & kAdate) return;
  start(edge_after(at));
}

void Adc::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  if (!runs) {
    core_.hold(sample_, state_.held_sample, at);
    core_.hold(end_, state_.held_end, at);
    return;
  }
  const Cycle stood = at - state_.held_end.since;
  state_.origin += stood;
  state_.start += stood;
  core_.go_on(sample_, state_.held_sample, at);
  core_.go_on(end_, state_.held_end, at);
}

}  // namespace robosim::avr
