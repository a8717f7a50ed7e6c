#include "sim/mcu/avr/spi.h"

namespace robosim::avr {

Spi::Spi(Core& core, Pins& pins)
    : core_(core),
      pins_(pins),
      control_(core.chip.spi.address),
      status_(static_cast<Address>(control_ + 1)),
      data_(static_cast<Address>(control_ + 2)),
      select_(pins.named(core.chip.spi.select)),
      out_(pins.named(core.chip.spi.out)),
      in_(pins.named(core.chip.spi.in)),
      clock_(pins.named(core.chip.spi.clock)) {
  for (const Address address : {control_, status_, data_}) {
    core.cpu.on_read<&Spi::read>(address, this);
    core.cpu.on_write<&Spi::write>(address, this);
    if (address != data_) core.cpu.on_forecast<&Spi::forecast>(address, this);
  }
  core.interrupts.on_entry<&Spi::entered>(core.chip.spi.vector, this);
  shifted_ = core.events.add<&Spi::shifted>(this);
  core.keep(state_);
}

void Spi::reset(Cycle) { state_ = {}; }

std::uint64_t Spi::may_interrupt() const {
  return Interrupts::bit(core_.chip.spi.vector, state_.master.shifting && core_.cpu.data[control_] & kSpie);
}

void Spi::request() {
  core_.request(core_.chip.spi.vector, core_.at(status_) & kSpif && core_.at(control_) & kSpie);
}

void Spi::entered(int) {
  core_.at(status_) &= static_cast<std::uint8_t>(~kSpif);
  request();
}

std::uint8_t Spi::read(Address address) {
  if (!state_.runs) return 0;
  if (address == data_) {
    state_.master.touch_data(core_.at(status_));
    request();
    return state_.master.received;
  }
  return address == status_ ? state_.master.read_status(core_.at(status_)) : core_.at(address);
}

// Returns no forecast for SPSR while a flag is set, or was set at the last read of SPSR. A read then has a
// side effect: the next access to SPDR clears the flags.
ReadForecast Spi::forecast(Address address, std::uint8_t) {
  if (!state_.runs) return {kNoCycle, 0};
  if (address == status_ && ((core_.at(status_) | state_.master.seen) & (kSpif | kWcol))) return {};
  return {kNoCycle, core_.at(address)};
}

void Spi::write(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  if (address == data_) return send(value);
  if (address == status_) return state_.master.write_status(core_.at(status_), value);
  core_.at(control_) = value;
  if (!(value & kSpe)) {
    state_.master.shifting = false;
    core_.events.cancel(shifted_);
  }
  look_at_select();
  drive();
  request();
}

void Spi::send(std::uint8_t value) {
  std::uint8_t& status = core_.at(status_);
  state_.master.touch_data(status);
  request();
  look_at_select();
  const std::uint8_t control = core_.at(control_);
  if (!state_.master.begin(control, status)) return;
  state_.sending = value;
  core_.schedule(shifted_, core_.now() + static_cast<Cycle>(SpiMaster::takes(control, status)));
}

void Spi::shifted(Cycle) {
  state_.master.end(core_.at(status_), pins_.level(in_));
  drive();
  request();
}

// Ends master mode if SS is an input at low level (19.3.2).
void Spi::look_at_select() {
  const ChipPin& place = core_.chip.pins[select_];
  const bool is_output =
      core_.at(static_cast<Address>(core_.chip.ports[place.port].address + 1)) >> place.bit & 1;
  if (!SpiMaster::is_on(core_.at(control_)) || is_output || pins_.level(select_)) return;
  state_.master.lose_bus(core_.at(control_), core_.at(status_));
  core_.events.cancel(shifted_);
  drive();
  request();
}

// In master mode, takes the pins (table 19-1): MISO is an input; the other pins are outputs if DDRx makes
// them outputs. Otherwise, gives the pins back.
void Spi::drive() {
  const bool master = SpiMaster::is_on(core_.at(control_));
  if (master) {
    const auto level = [this](int pin, bool high) {
      PinDrive drive;
      drive.mode = PinMode::output;
      drive.level = high;
      drive.duty = high ? 1.0 : 0.0;
      pins_.take(pin, drive);
    };
    level(out_, state_.sending & 1);
    level(clock_, core_.at(control_) & kCpol);
    if (!state_.takes_pins) pins_.take(in_, {}, true);
  } else if (state_.takes_pins) {
    for (const int pin : {out_, clock_, in_}) pins_.give_back(pin);
  }
  state_.takes_pins = master;
}

void Spi::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  core_.hold_or_go_on(shifted_, state_.held, runs, at);
}

}  // namespace robosim::avr
