#include "sim/mcu/avr/spi.h"

namespace robosim::avr {
namespace {

// Bits of SPCR, then of SPSR.
constexpr std::uint8_t kSpie = 0x80, kSpe = 0x40, kMstr = 0x10, kCpol = 0x08, kSprMask = 0x03;
constexpr std::uint8_t kSpif = 0x80, kWcol = 0x40, kSpi2x = 0x01;

}  // namespace

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

bool Spi::is_master() const { return (core_.cpu.data[control_] & (kSpe | kMstr)) == (kSpe | kMstr); }

Cycle Spi::transfer() const {
  constexpr Cycle kDivisors[4] = {4, 16, 64, 128};
  const Cycle divisor = kDivisors[core_.cpu.data[control_] & kSprMask];
  return 8 * (core_.cpu.data[status_] & kSpi2x ? divisor / 2 : divisor);
}

std::uint64_t Spi::may_interrupt() const {
  return Interrupts::bit(core_.chip.spi.vector, state_.shifting && core_.cpu.data[control_] & kSpie);
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
    touch_data();
    return state_.received;
  }
  if (address == status_) state_.seen = core_.at(status_) & (kSpif | kWcol);
  return core_.at(address);
}

// Returns no forecast for SPSR while a flag is set, or was set at the last read of SPSR. A read then has a
// side effect: the next access to SPDR clears the flags.
ReadForecast Spi::forecast(Address address, std::uint8_t) {
  if (!state_.runs) return {kNoCycle, 0};
  if (address == status_ && ((core_.at(status_) | state_.seen) & (kSpif | kWcol))) return {};
  return {kNoCycle, core_.at(address)};
}

void Spi::touch_data() {
  core_.at(status_) &= static_cast<std::uint8_t>(~state_.seen);
  state_.seen = 0;
  request();
}

void Spi::write(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  if (address == data_) return send(value);
  if (address == status_) {
    core_.at(status_) = static_cast<std::uint8_t>((core_.at(status_) & (kSpif | kWcol)) | (value & kSpi2x));
    return;
  }
  core_.at(control_) = value;
  if (!(value & kSpe)) {
    state_.shifting = false;
    core_.events.cancel(shifted_);
  }
  look_at_select();
  drive();
  request();
}

void Spi::send(std::uint8_t value) {
  touch_data();
  look_at_select();
  if (state_.shifting) {
    core_.at(status_) |= kWcol;
  } else if (is_master()) {
    state_.shifting = true;
    state_.sending = value;
    core_.schedule(shifted_, core_.now() + transfer());
  }
}

void Spi::shifted(Cycle) {
  state_.shifting = false;
  state_.received = pins_.level(in_) ? 0xFF : 0x00;
  core_.at(status_) |= kSpif;
  drive();
  request();
}

// Ends master mode if SS is an input at low level (19.3.2).
void Spi::look_at_select() {
  const ChipPin& place = core_.chip.pins[select_];
  const bool is_output =
      core_.at(static_cast<Address>(core_.chip.ports[place.port].address + 1)) >> place.bit & 1;
  if (!is_master() || is_output || pins_.level(select_)) return;
  core_.at(control_) &= static_cast<std::uint8_t>(~kMstr);
  core_.at(status_) |= kSpif;
  state_.shifting = false;
  core_.events.cancel(shifted_);
  drive();
  request();
}

// Takes the pins of a master (table 19-1): MISO is an input; the other pins are outputs if DDRx makes them
// outputs.
void Spi::drive() {
  const bool master = is_master();
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
