#include "sim/exec/avr/uart.h"

namespace robosim::exec::avr {
namespace {

constexpr std::uint8_t kRxc = 0x80, kTxc = 0x40, kUdre = 0x20, kDor = 0x08, kU2x = 0x02, kMpcm = 0x01;
constexpr std::uint8_t kRxcie = 0x80, kUdrie = 0x20, kRxen = 0x10, kTxen = 0x08, kRxb8 = 0x02;

}  // namespace

Uart::Uart(Link& link, int number) : link_(link), module_(link.chip.find_module<avr_uart_t>("uart", number)) {
  const UartSpec& uart = link.chip.spec().uarts[number];
  status_at_ = static_cast<reg::Address>(uart.address);
  control_at_ = static_cast<reg::Address>(status_at_ + 1);
  format_at_ = static_cast<reg::Address>(status_at_ + 2);
  divider_at_ = uart.divider;
  data_at_ = uart.data;
  was_reset();
}

Cycle Uart::byte_cycles() const {
  const Chip& chip = link_.chip;
  const int format = chip.data(format_at_);
  const int bits = 1 + 5 + (format >> 1 & 3) + (format & 0x20 ? 1 : 0) + (format & 0x08 ? 2 : 1);
  const int divider =
      (chip.data(divider_at_) | chip.data(static_cast<reg::Address>(divider_at_ + 1)) << 8) & 0xFFF;
  return static_cast<Cycle>(bits) * (chip.data(status_at_) & kU2x ? 8 : 16) * static_cast<Cycle>(divider + 1);
}

void Uart::listen() {
  const auto byte_time = link_.cycles.of(static_cast<SimTime>(byte_cycles()));
  link_.board.listen(control() & kRxen ? byte_time : 0, link_.now());
}

void Uart::raise(avr_int_vector_t& vector) { avr_raise_interrupt(link_.chip.simavr(), &vector); }

void Uart::clear(avr_int_vector_t& vector, std::uint8_t flag) {
  avr_clear_interrupt(link_.chip.simavr(), &vector);
  status() &= static_cast<std::uint8_t>(~flag);
}

void Uart::write(reg::Address address, std::uint8_t value) {
  if (address == data_at_) return send(value);
  if (address == control_at_) return set_control(value);
  if (address == status_at_) {
    if (value & kTxc) clear(module_->txc, kTxc);
    status() = static_cast<std::uint8_t>((status() & ~(kU2x | kMpcm)) | (value & (kU2x | kMpcm)));
  } else {
    link_.chip.memory()[address] = value;
  }
  listen();
}

void Uart::set_control(std::uint8_t value) {
  const std::uint8_t rising = value & ~control();
  link_.chip.memory()[control_at_] = value & static_cast<std::uint8_t>(~kRxb8);
  if (!(value & kRxen)) {
    received_count_ = 0;
    clear(module_->rxc, kRxc);
  }
  if (rising & kRxcie && received_count_ > 0) raise(module_->rxc);
  if (rising & kUdrie && !waiting_) raise(module_->udrc);
  listen();
}

void Uart::send(std::uint8_t byte) {
  if (!(control() & kTxen) || waiting_) return;
  link_.board.send_byte(byte, link_.now());
  if (shifting_) {
    waiting_ = true;
    clear(module_->udrc, kUdre);
    return;
  }
  shifting_ = true;
  avr_cycle_timer_register(link_.chip.simavr(), byte_cycles(), &Uart::on_shifted, this);
  raise(module_->udrc);
}

avr_cycle_count_t Uart::on_shifted(avr_t*, avr_cycle_count_t when, void* self) {
  auto& uart = *static_cast<Uart*>(self);
  if (uart.waiting_) {
    uart.waiting_ = false;
    uart.raise(uart.module_->udrc);
    return when + uart.byte_cycles();
  }
  uart.shifting_ = false;
  uart.raise(uart.module_->txc);
  return 0;
}

void Uart::receive(std::uint8_t byte) {
  if (!(control() & kRxen)) return;
  if (received_count_ == 2) {
    status() |= kDor;
    return;
  }
  received_[static_cast<std::size_t>(received_count_++)] = byte;
  raise(module_->rxc);
}

std::uint8_t Uart::take() {
  if (received_count_ == 0) return 0;
  const std::uint8_t byte = received_[0];
  received_[0] = received_[1];
  --received_count_;
  status() &= static_cast<std::uint8_t>(~kDor);
  clear(module_->rxc, kRxc);
  if (received_count_ > 0) raise(module_->rxc);
  return byte;
}

std::uint8_t Uart::read(reg::Address address) {
  return address == data_at_ ? take() : link_.chip.data(address);
}

void Uart::was_reset() {
  shifting_ = waiting_ = false;
  received_count_ = 0;
  std::uint8_t* const memory = link_.chip.memory();
  memory[status_at_] = kUdre;
  memory[control_at_] = 0;
  memory[format_at_] = 0x06;
  listen();
}

}  // namespace robosim::exec::avr
