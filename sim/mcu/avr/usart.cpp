#include "sim/mcu/avr/usart.h"

#include <utility>

namespace robosim::avr {
namespace {

constexpr std::uint8_t kUbrrHighBits = 0x0F;
constexpr std::uint16_t kNinthBit = 0x100;

}  // namespace

Usart::Usart(Core& core, Pins& pins, int number)
    : core_(core),
      pins_(pins),
      number_(number),
      spec_(core.chip.uarts[number]),
      status_(static_cast<Address>(spec_.address)),
      control_(static_cast<Address>(status_ + 1)),
      format_(static_cast<Address>(status_ + 2)),
      divider_(spec_.divider),
      data_(spec_.data),
      rx_pin_(pins.named(spec_.rx)),
      tx_pin_(pins.named(spec_.tx)) {
  for (const Address address :
       {status_, control_, format_, divider_, static_cast<Address>(divider_ + 1), data_}) {
    core.cpu.on_read<&Usart::read>(address, this);
    core.cpu.on_write<&Usart::write>(address, this);
    if (address != data_) core.cpu.is_steady(address);
  }
  core.interrupts.on_entry<&Usart::sent_entered>(spec_.vector + 2, this);
  shifted_ = core.events.add<&Usart::shifted>(this);
  core.keep(state_);
}

void Usart::reset(Cycle at) {
  const bool told = state_.told != 0;
  state_ = {};
  core_.at(format_) = kUcsrcAtReset;
  if (told) core_.environment.listens(number_, 0, at);
}

std::uint16_t Usart::data_mask() const {
  return static_cast<std::uint16_t>((1u << usart_data_bits(data(control_), data(format_))) - 1);
}

Cycle Usart::frame() const {
  return static_cast<Cycle>(
      usart_frame(data(status_), data(control_), data(format_), core_.cpu.pair(divider_)));
}

void Usart::tell() {
  const Cycle now = state_.runs && data(control_) & kRxen ? frame() : 0;
  if (now == state_.told) return;
  state_.told = now;
  core_.environment.listens(number_, now, core_.now());
}

std::uint64_t Usart::may_interrupt() const {
  const std::uint8_t control = core_.cpu.data[control_];
  return Interrupts::bit(spec_.vector, control & kRxen && control & kRxcie) |
         Interrupts::bit(spec_.vector + 1, control & kUdrie) |
         Interrupts::bit(spec_.vector + 2, control & kTxcie);
}

void Usart::request() {
  const std::uint8_t control = data(control_);
  core_.request(spec_.vector, state_.receiver.count > 0 && control & kRxcie);
  core_.request(spec_.vector + 1, !state_.waiting && control & kUdrie);
  core_.request(spec_.vector + 2, data(status_) & kTxc && control & kTxcie);
}

void Usart::sent_entered(int) {
  core_.at(status_) &= static_cast<std::uint8_t>(~kTxc);
  request();
}

std::uint8_t Usart::read(Address address) {
  if (!state_.runs) return 0;
  if (address == data_) return read_data();
  std::uint8_t value = data(address);
  if (address == status_) {
    if (state_.receiver.count > 0) value |= kRxc;
    if (!state_.waiting) value |= kUdre;
    if (state_.receiver.overrun) value |= kDor;
  } else if (address == control_) {
    if (state_.receiver.next() & kNinthBit) value |= kRxb8;
  }
  return value;
}

std::uint8_t Usart::read_data() {
  const auto read = static_cast<std::uint8_t>(state_.receiver.take());
  request();
  return read;
}

void Usart::write(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  if (address == data_) return write_data(value);
  if (address == control_) return write_control(value);
  if (address == status_) {
    const auto sent = static_cast<std::uint8_t>(data(status_) & kTxc & ~value);
    core_.at(status_) = static_cast<std::uint8_t>(sent | (value & (kU2x | kMpcm)));
    request();
  } else if (address == divider_ + 1) {
    core_.at(address) = value & kUbrrHighBits;
  } else {
    core_.at(address) = value;
  }
  tell();
}

void Usart::write_control(std::uint8_t value) {
  core_.at(control_) = value & static_cast<std::uint8_t>(~kRxb8);
  if (!(value & kRxen)) state_.receiver.clear();
  if (value & kTxen && std::exchange(state_.early, false) && !state_.shifting)
    begin(state_.waiting_data, core_.now());
  take_pins();
  request();
  tell();
}

// Takes the pins from the port, or gives them back. TXEN = 0 takes effect when nothing is left to send
// (20.6.5).
void Usart::take_pins() {
  const auto update = [this](int pin, bool taken, bool& before, const PinDrive& drive) {
    if (pin < 0 || taken == before) return;
    before = taken;
    if (taken) {
      pins_.take(pin, drive, true);
    } else {
      pins_.give_back(pin);
    }
  };
  PinDrive idle;
  idle.mode = PinMode::output;
  idle.level = true;
  idle.duty = 1.0;
  update(tx_pin_, data(control_) & kTxen || state_.shifting, state_.drives, idle);
  update(rx_pin_, data(control_) & kRxen, state_.listens, {});
}

void Usart::write_data(std::uint8_t value) {
  if (state_.waiting) return;
  const auto frame_data = static_cast<std::uint16_t>(value | (data(control_) & kTxb8 ? kNinthBit : 0));
  if (!(data(control_) & kTxen)) {
    state_.early = true;
    state_.waiting_data = frame_data;
    return;
  }
  if (!state_.shifting) return begin(frame_data, core_.now());
  state_.waiting = true;
  state_.waiting_data = frame_data;
  request();
}

void Usart::begin(std::uint16_t frame_data, Cycle at) {
  state_.shifting = true;
  core_.environment.sent(number_, frame_data & data_mask(), at);
  core_.schedule(shifted_, at + frame());
}

void Usart::shifted(Cycle at) {
  if (state_.waiting) {
    state_.waiting = false;
    begin(state_.waiting_data, at);
  } else {
    state_.shifting = false;
    core_.at(status_) |= kTxc;
    take_pins();
  }
  request();
}

void Usart::receive(std::uint16_t frame_data, Cycle) {
  if (!state_.runs || !(data(control_) & kRxen)) return;
  const bool fits = state_.receiver.add(frame_data & data_mask());
  if (!fits && data(control_) & kRxcie) core_.lose(spec_.vector);
  request();
}

void Usart::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  core_.hold_or_go_on(shifted_, state_.held, runs, at);
  tell();
}

}  // namespace robosim::avr
