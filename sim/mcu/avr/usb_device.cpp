#include "sim/mcu/avr/usb_device.h"

#include <algorithm>

namespace robosim::avr {
namespace {

// Offsets of registers from USBCON.
constexpr int kUsbcon = 0x00, kUsbsta = 0x01, kUdcon = 0x08, kUdint = 0x09, kUdien = 0x0A, kUdfnumL = 0x0C,
              kUdfnumH = 0x0D, kUeintx = 0x10, kUenum = 0x11, kUerst = 0x12, kUeconx = 0x13, kUecfg0x = 0x14,
              kUecfg1x = 0x15, kUesta0x = 0x16, kUeienx = 0x18, kUedatx = 0x19, kUebclx = 0x1A,
              kUebchx = 0x1B, kUeint = 0x1C;
// Bits of USBCON, USBSTA and UDCON.
constexpr std::uint8_t kUsbe = 0x80, kFrzclk = 0x20, kOtgpade = 0x10, kVbus = 0x01, kFullSpeed = 0x08,
                       kDetach = 0x01;
// Bits of UDINT.
constexpr std::uint8_t kSofi = 0x04, kEorsti = 0x08;
// Bits of UECONX, UECFG1X and UESTA0X.
constexpr std::uint8_t kEpen = 0x01, kStallrq = 0x20, kStallrqc = 0x10, kAlloc = 0x02, kCfgok = 0x80;
// Bits of UEINTX.
constexpr std::uint8_t kFifocon = 0x80, kRwal = 0x20, kRxstpi = 0x08, kRxouti = 0x04, kStalledi = 0x02,
                       kTxini = 0x01;
constexpr std::uint8_t kFlags = kRxstpi | kRxouti | kStalledi | kTxini;
// Bits of PLLCSR.
constexpr std::uint8_t kPlle = 0x02, kPlock = 0x01;
constexpr std::int64_t kLock_ns = 100'000;
constexpr std::uint16_t kFrameMask = 0x7FF;

}  // namespace

void UsbDevice::Endpoint::clear_banks() {
  waiting = read = filling.count = 0;
  armed = false;
  flags = !is_control() && is_in() ? kTxini : 0;
}

void UsbDevice::Endpoint::drop_first() {
  banks[0] = banks[1];
  read = 0;
  if (waiting > 0) --waiting;
}

UsbDevice::UsbDevice(Core& core) : core_(core) {
  for (int offset = kUsbcon; offset <= kUeint; ++offset) {
    core.cpu.on_read<&UsbDevice::read>(at(offset), this);
    core.cpu.on_write<&UsbDevice::write>(at(offset), this);
  }
  core.cpu.on_read<&UsbDevice::read_pll>(core.chip.usb.pll, this);
  core.cpu.on_write<&UsbDevice::write_pll>(core.chip.usb.pll, this);
  core.keep(state_);
}

void UsbDevice::reset(Cycle) {
  state_ = {};
  core_.at(at(kUdcon)) = kDetach;
  on_attachment();
}

bool UsbDevice::is_attached() const {
  const std::uint8_t control = core_.cpu.data[at(kUsbcon)];
  return control & kUsbe && control & kOtgpade && !(control & kFrzclk) &&
         !(core_.cpu.data[at(kUdcon)] & kDetach);
}

UsbDevice::Endpoint& UsbDevice::selected() {
  return state_.endpoints[std::min<std::size_t>(core_.at(at(kUenum)) & 7, kEndpoints - 1)];
}

std::uint8_t UsbDevice::read_pll(Address address) {
  const bool locked = core_.now() >= state_.locked_at;
  return static_cast<std::uint8_t>(core_.at(address) | (locked ? kPlock : 0));
}

void UsbDevice::write_pll(Address address, std::uint8_t value) {
  const std::uint8_t before = core_.at(address);
  core_.at(address) = value & static_cast<std::uint8_t>(~kPlock);
  if (!(value & kPlle)) {
    state_.locked_at = kNoCycle;
  } else if (!(before & kPlle)) {
    state_.locked_at = core_.now() + core_.cycles(kLock_ns);
  }
}

std::uint8_t UsbDevice::endpoints_with_request() const {
  int bits = 0;
  for (std::size_t i = 0; i < kEndpoints; ++i)
    if (state_.endpoints[i].flags & state_.endpoints[i].enables) bits |= 1 << i;
  return static_cast<std::uint8_t>(bits);
}

std::uint64_t UsbDevice::may_interrupt() const {
  const bool endpoints = std::any_of(std::begin(state_.endpoints), std::end(state_.endpoints),
                                     [](const Endpoint& e) { return e.enables != 0; });
  return Interrupts::bit(core_.chip.usb.vector, core_.cpu.data[at(kUdien)] != 0) |
         Interrupts::bit(core_.chip.usb.vector + 1, endpoints);
}

void UsbDevice::request() {
  core_.request(core_.chip.usb.vector, core_.at(at(kUdint)) & core_.at(at(kUdien)));
  core_.request(core_.chip.usb.vector + 1, endpoints_with_request() != 0);
}

std::uint8_t UsbDevice::read_flags(const Endpoint& endpoint) const {
  int value = endpoint.flags;
  if (!endpoint.is_control() && endpoint.control & kEpen && endpoint.has_bank())
    value |= kFifocon | (endpoint.may_access() ? kRwal : 0);
  return static_cast<std::uint8_t>(value);
}

std::uint8_t UsbDevice::read_data(Endpoint& endpoint) {
  if (endpoint.waiting == 0 || endpoint.read >= endpoint.banks[0].count) return 0;
  return endpoint.banks[0].bytes[endpoint.read++];
}

std::uint8_t UsbDevice::byte_count(const Endpoint& endpoint) const {
  const bool out = endpoint.is_control() ? endpoint.waiting > 0 : !endpoint.is_in();
  if (!out) return endpoint.filling.count;
  return endpoint.waiting > 0 ? static_cast<std::uint8_t>(endpoint.banks[0].count - endpoint.read) : 0;
}

std::uint8_t UsbDevice::read(Address address) {
  Endpoint& endpoint = selected();
  switch (address - at(0)) {
    case kUsbsta:
      return kVbus | kFullSpeed;
    case kUdfnumL:
      return static_cast<std::uint8_t>(state_.frame);
    case kUdfnumH:
      return static_cast<std::uint8_t>(state_.frame >> 8);
    case kUeintx:
      return read_flags(endpoint);
    case kUeconx:
      return endpoint.control;
    case kUecfg0x:
      return endpoint.direction;
    case kUecfg1x:
      return endpoint.layout;
    case kUesta0x:
      return static_cast<std::uint8_t>((endpoint.layout & kAlloc ? kCfgok : 0) | endpoint.waiting);
    case kUeienx:
      return endpoint.enables;
    case kUedatx:
      return read_data(endpoint);
    case kUebclx:
      return byte_count(endpoint);
    case kUebchx:
      return 0;
    case kUeint:
      return endpoints_with_request();
    default:
      return core_.at(address);
  }
}

void UsbDevice::write(Address address, std::uint8_t value) {
  Endpoint& endpoint = selected();
  switch (address - at(0)) {
    case kUsbcon:
    case kUdcon:
      core_.at(address) = value;
      on_attachment();
      break;
    case kUdint:  // writing 0 to a flag clears the flag
      core_.at(address) &= value;
      break;
    case kUeintx:
      write_flags(endpoint, value);
      break;
    case kUerst:
      for (std::size_t i = 0; i < kEndpoints; ++i)
        if (value >> i & 1) state_.endpoints[i].clear_banks();
      core_.at(address) = value;
      break;
    case kUeconx:
      endpoint.control = value & (value & kStallrqc ? kEpen : kEpen | kStallrq);
      break;
    case kUecfg0x:
      endpoint.direction = value;
      break;
    case kUecfg1x:
      endpoint.layout = value;
      if (value & kAlloc) endpoint.clear_banks();
      break;
    case kUeienx:
      endpoint.enables = value & kFlags;
      break;
    case kUedatx:
      if ((endpoint.is_control() || endpoint.may_access()) && endpoint.filling.count < endpoint.size())
        endpoint.filling.bytes[endpoint.filling.count++] = value;
      break;
    case kUsbsta:
    case kUdfnumL:
    case kUdfnumH:
    case kUesta0x:
    case kUebclx:
    case kUebchx:
    case kUeint:
      break;
    default:
      core_.at(address) = value;
  }
  request();
}

void UsbDevice::write_flags(Endpoint& endpoint, std::uint8_t value) {
  const std::uint8_t before = read_flags(endpoint);
  endpoint.flags &= value;
  if (endpoint.is_control()) return write_control_flags(endpoint, before, value);
  if (!(before & kFifocon) || value & kFifocon) return;
  if (endpoint.is_in()) {
    endpoint.banks[endpoint.waiting++] = endpoint.filling;
    endpoint.filling.count = 0;
    if (endpoint.has_bank()) endpoint.flags |= kTxini;
    on_filled();
  } else {
    endpoint.drop_first();
    if (endpoint.waiting > 0) endpoint.flags |= kRxouti;
  }
}

void UsbDevice::write_control_flags(Endpoint& endpoint, std::uint8_t before, std::uint8_t value) {
  const auto cleared = static_cast<std::uint8_t>(before & ~value);
  if (cleared & (kRxstpi | kRxouti)) endpoint.waiting = endpoint.read = 0;
  if (cleared & kRxstpi) {
    endpoint.flags |= kTxini;
  } else if (cleared & kTxini) {
    endpoint.armed = true;
    on_filled();
  }
}

// --- the host's side

void UsbDevice::bus_was_reset() {
  state_.endpoints = {};
  core_.at(at(kUdint)) |= kEorsti;
  request();
}

void UsbDevice::frame_began() {
  state_.frame = (state_.frame + 1) & kFrameMask;
  core_.at(at(kUdint)) |= kSofi;
  request();
}

void UsbDevice::setup(const std::array<std::uint8_t, 8>& packet) {
  Endpoint& endpoint = state_.endpoints[0];
  endpoint.clear_banks();
  std::copy(packet.begin(), packet.end(), endpoint.banks[0].bytes.begin());
  endpoint.banks[0].count = static_cast<std::uint8_t>(packet.size());
  endpoint.waiting = 1;
  endpoint.control &= static_cast<std::uint8_t>(~kStallrq);
  endpoint.flags = kRxstpi;
  request();
}

UsbDevice::Answer UsbDevice::take(std::size_t number, Packet& packet) {
  Endpoint& endpoint = state_.endpoints[number];
  if (endpoint.control & kStallrq) return Answer::stall;
  if (endpoint.is_control()) {
    if (!endpoint.armed) return Answer::later;
    packet = endpoint.filling;
    endpoint.filling.count = 0;
    endpoint.armed = false;
  } else {
    if (endpoint.waiting == 0) return Answer::later;
    packet = endpoint.banks[0];
    endpoint.drop_first();
  }
  endpoint.flags |= kTxini;
  request();
  return Answer::done;
}

UsbDevice::Answer UsbDevice::give(std::size_t number, const Packet& packet) {
  Endpoint& endpoint = state_.endpoints[number];
  if (endpoint.control & kStallrq) return Answer::stall;
  const std::uint8_t room = endpoint.is_control() ? 1 : endpoint.capacity();
  if (!(endpoint.control & kEpen) || endpoint.waiting >= room) return Answer::later;
  endpoint.banks[endpoint.waiting++] = packet;
  endpoint.flags |= kRxouti;
  request();
  return Answer::done;
}

}  // namespace robosim::avr
