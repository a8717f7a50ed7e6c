#include "sim/exec/stm32/usart.h"

#include <string_view>

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kErrors = 1u << 0;  // USART_CR3: EIE; there are none

ChipPin pin_named(std::string_view name) {
  for (int i = 0; i < kStm32f103c8.pin_count; ++i)
    if (const auto& pin = kStm32f103c8.pins[i]; name == pin.name) return {pin.port, pin.bit};
  return {};
}

}  // namespace

Usart::Usart(Link& link, const Clocks& clocks, int index)
    : link_(link),
      clocks_(clocks),
      spec_(stm32f103c8::kUarts[index]),
      pin_(pin_named(spec_.tx)),
      connected_(index == link.board.spec().serial_line) {}

bool Usart::drives(ChipPin pin, PinDrive& drive) const {
  if (!sends() || pin != pin_now()) return false;
  drive.level = true;  // a line at rest; its bytes are told as bytes
  return true;
}

ChipPin Usart::pin_now() const { return usart_pin(spec_.number, link_.map, pin_); }

Cycle Usart::byte_cycles() const {
  const unsigned bits = 1 + (control_ & kM ? 9 : 8) + ((control2_ & kStop2) == kStop2 ? 2 : 1);
  const std::uint32_t bus = clocks_.bus_divider(base());
  return Cycle{bits} * bus * (divider_ > 0 ? divider_ : 16);
}

void Usart::listen() {
  if (!connected_) return;
  const bool listens = on() && control_ & kRe;
  const auto byte_time =
      static_cast<SimTime>(byte_cycles()) * kSecond / static_cast<SimTime>(link_.clock.hz());
  link_.board.listen(listens ? byte_time : 0, link_.clock.time());
}

void Usart::refresh_line() {
  const bool high = (status_ & kTxe && control_ & kTxeie) || (status_ & kTc && control_ & kTcie) ||
                    (status_ & (kRxne | kOre) && control_ & kRxneie) ||
                    (status_ & kIdleLine && control_ & kIdleie);
  link_.nvic.set_line(static_cast<Irq>(spec_.vector), on() && high);
}

void Usart::send(std::uint8_t byte) {
  if (!sends()) return;
  status_ &= ~kTc;
  if (shifting_) {
    waiting_ = byte;  // instead of one that waits already
    status_ &= ~kTxe;
    return;
  }
  shift(byte, link_.clock.now);
}

void Usart::shift(std::uint8_t byte, Cycle at) {
  if (connected_) link_.board.send_byte(byte, link_.clock.time_of(at));
  shifting_ = true;
  sent_at_ = at + byte_cycles();
}

void Usart::update() {
  while (shifting_ && link_.clock.now >= sent_at_) {
    if (status_ & kTxe) {
      shifting_ = false;
      status_ |= kTc;
    } else {
      status_ |= kTxe;
      shift(waiting_, sent_at_);
    }
    refresh_line();
  }
  if (link_.clock.now >= idle_at_) {
    idle_at_ = kNoCycle;
    status_ |= kIdleLine;
    refresh_line();
  }
}

// RM0008 table 78
unsigned Usart::dma_requests() const {
  constexpr int kSends[] = {4, 7, 2}, kReceives[] = {5, 6, 3};
  const int index = spec_.number - 1;
  unsigned requests = 0;
  if (sends() && control3_ & kDmaT && status_ & kTxe) requests |= dma_channel(kSends[index]);
  if (on() && control3_ & kDmaR && status_ & kRxne) requests |= dma_channel(kReceives[index]);
  return requests;
}

void Usart::receive(std::uint8_t byte) {
  if (!connected_ || !on() || !(control_ & kRe)) return;
  if (status_ & kRxne) {
    status_ |= kOre;
  } else {
    received_ = byte;
    status_ |= kRxne;
  }
  // A whole frame and a bit without another.
  idle_at_ = link_.clock.now + byte_cycles() / 10 * 11;
  refresh_line();
}

void Usart::reset(Address) {
  static_cast<UsartRegisters&>(*this) = {};
  listen();
  refresh_line();
  link_.pin_changed(pin_now());
}

std::uint32_t Usart::read(Address address) {
  update();
  switch (address - base() + kUsart1) {
    case kUsartSr:
      return status_;
    case kUsartDr:
      status_ &= ~(kRxne | kOre | kIdleLine);
      refresh_line();
      return received_;
    case kUsartBrr:
      return divider_;
    case kUsartCr1:
      return control_;
    case kUsartCr2:
      return control2_;
    case kUsartCr3:
      return control3_;
    default:
      return 0;
  }
}

bool Usart::write(Address address, std::uint32_t value) {
  update();
  const bool sent = sends();
  bool modelled = true;
  switch (address - base() + kUsart1) {
    case kUsartSr:
      status_ &= value | ~(kTc | kRxne);
      break;
    case kUsartDr:
      send(static_cast<std::uint8_t>(value));
      break;
    case kUsartBrr:
      divider_ = value & 0xFFFF;
      listen();
      break;
    case kUsartCr1:
      control_ = value;
      modelled = (value & ~(kUe | kTe | kRe | kIdleie | kRxneie | kTcie | kTxeie | kM | kPce | kPs)) == 0;
      listen();
      break;
    case kUsartCr2:
      control2_ = value;
      modelled = (value & ~kStop2) == 0;
      listen();
      break;
    case kUsartCr3:
      control3_ = value;
      modelled = (value & ~(kDmaR | kDmaT | kErrors)) == 0;  // no hardware flow control
      break;
    default:
      modelled = value == 0;  // USART_GTPR
  }
  refresh_line();
  if (sends() != sent) link_.pin_changed(pin_now());
  return modelled;
}

}  // namespace robosim::exec::stm32
