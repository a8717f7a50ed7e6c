#include "sim/exec/stm32/usart.h"

#include <string_view>

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kErrors = 1u << 0;  // USART_CR3: EIE (interrupt on errors with DMA), has no effect

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
      connected_(index == link.board.spec().serial_line) {
  link.snapshots.add(state_);
}

bool Usart::drives(ChipPin pin, PinDrive& drive) const {
  if (!sends() || pin != pin_now()) return false;
  drive.level = true;  // the line is reported as idle; bytes are reported separately
  return true;
}

ChipPin Usart::pin_now() const { return usart_pin(spec_.number, link_.map, pin_); }

Cycle Usart::byte_cycles() const {
  const unsigned bits = 1 + (state_.control & kM ? 9 : 8) + ((state_.control2 & kStop2) == kStop2 ? 2 : 1);
  const std::uint32_t bus = clocks_.bus_divider(base());
  return Cycle{bits} * bus * (state_.divider > 0 ? state_.divider : 16);
}

void Usart::listen() {
  if (!connected_) return;
  const bool listens = on() && state_.control & kRe;
  const auto byte_time =
      static_cast<SimTime>(byte_cycles()) * kSecond / static_cast<SimTime>(link_.clock.hz());
  link_.board.listen(listens ? byte_time : 0, link_.clock.time());
}

void Usart::refresh_line() {
  const bool high = (state_.status & kTxe && state_.control & kTxeie) ||
                    (state_.status & kTc && state_.control & kTcie) ||
                    (state_.status & (kRxne | kOre) && state_.control & kRxneie) ||
                    (state_.status & kIdleLine && state_.control & kIdleie);
  link_.nvic.set_line(static_cast<Irq>(spec_.vector), on() && high);
}

void Usart::send(std::uint8_t byte) {
  if (!sends()) return;
  state_.status &= ~kTc;
  if (state_.shifting) {
    state_.waiting = byte;  // replaces a byte that is already waiting
    state_.status &= ~kTxe;
    return;
  }
  shift(byte, link_.clock.now);
}

void Usart::shift(std::uint8_t byte, Cycle at) {
  if (connected_) link_.board.send_byte(byte, link_.clock.time_of(at));
  state_.shifting = true;
  state_.sent_at = at + byte_cycles();
}

void Usart::update() {
  while (state_.shifting && link_.clock.now >= state_.sent_at) {
    if (state_.status & kTxe) {
      state_.shifting = false;
      state_.status |= kTc;
    } else {
      state_.status |= kTxe;
      shift(state_.waiting, state_.sent_at);
    }
    refresh_line();
  }
  if (link_.clock.now >= state_.idle_at) {
    state_.idle_at = kNoCycle;
    state_.status |= kIdleLine;
    refresh_line();
  }
}

// Returns the DMA channels that the USART requests, by RM0008, table 78.
unsigned Usart::dma_requests() const {
  constexpr int kSends[] = {4, 7, 2}, kReceives[] = {5, 6, 3};
  const int index = spec_.number - 1;
  unsigned requests = 0;
  if (sends() && state_.control3 & kDmaT && state_.status & kTxe) requests |= dma_channel(kSends[index]);
  if (on() && state_.control3 & kDmaR && state_.status & kRxne) requests |= dma_channel(kReceives[index]);
  return requests;
}

void Usart::receive(std::uint8_t byte) {
  if (!connected_ || !on() || !(state_.control & kRe)) return;
  if (state_.status & kRxne) {
    state_.status |= kOre;
  } else {
    state_.received = byte;
    state_.status |= kRxne;
  }
  // The line counts as idle if no other frame arrives for the duration of a frame and one bit.
  state_.idle_at = link_.clock.now + byte_cycles() / 10 * 11;
  refresh_line();
}

void Usart::reset(Address) {
  state_ = {};
  listen();
  refresh_line();
  link_.pin_changed(pin_now());
}

std::uint32_t Usart::read(Address address) {
  update();
  switch (address - base() + kUsart1) {
    case kUsartSr:
      return state_.status;
    case kUsartDr:
      state_.status &= ~(kRxne | kOre | kIdleLine);
      refresh_line();
      return state_.received;
    case kUsartBrr:
      return state_.divider;
    case kUsartCr1:
      return state_.control;
    case kUsartCr2:
      return state_.control2;
    case kUsartCr3:
      return state_.control3;
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
      state_.status &= value | ~(kTc | kRxne);
      break;
    case kUsartDr:
      send(static_cast<std::uint8_t>(value));
      break;
    case kUsartBrr:
      state_.divider = value & 0xFFFF;
      listen();
      break;
    case kUsartCr1:
      state_.control = value;
      modelled = (value & ~(kUe | kTe | kRe | kIdleie | kRxneie | kTcie | kTxeie | kM | kPce | kPs)) == 0;
      listen();
      break;
    case kUsartCr2:
      state_.control2 = value;
      modelled = (value & ~kStop2) == 0;
      listen();
      break;
    case kUsartCr3:
      state_.control3 = value;
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
