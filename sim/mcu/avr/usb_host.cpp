#include "sim/mcu/avr/usb_host.h"

#include <algorithm>

namespace robosim::avr {
namespace {

using Answer = UsbDevice::Answer;

constexpr std::int64_t kMillisecond_ns = 1'000'000, kDebounce_ns = 100 * kMillisecond_ns,
                       kReset_ns = 10 * kMillisecond_ns, kTransaction_ns = 100'000, kByte_ns = 1'500;
// Requests of the enumeration, in order.
enum Step : std::uint8_t {
  kDevice,
  kAddress,
  kConfigurationHead,
  kConfiguration,
  kConfigure,
  kLineCoding,
  kLineState,
  kSteps
};
constexpr std::uint8_t kToHost = 0x80, kOfInterface = 0x21;
constexpr std::uint8_t kGetDescriptor = 6, kSetAddress = 5, kSetConfiguration = 9, kSetLineCoding = 0x20,
                       kSetControlLineState = 0x22;
constexpr std::uint16_t kDeviceDescriptor = 0x100, kConfigurationDescriptor = 0x200, kReady = 3;  // DTR, RTS
constexpr std::array<std::uint8_t, 7> kCoding{0x00, 0xC2, 0x01, 0x00, 0, 0, 8};  // 115200 8N1
constexpr std::uint8_t kInterface = 4, kEndpoint = 5, kCommunication = 2, kData = 10, kIn = 0x80;

}  // namespace

UsbHost::UsbHost(Core& core, UsbDevice& device) : core_(core), device_(device) {
  device.on_attachment = Cpu::call<&UsbHost::attachment_changed>(this);
  device.on_filled = Cpu::call<&UsbHost::filled>(this);
  act_ = core.events.add<&UsbHost::act>(this);
  frame_ = core.events.add<&UsbHost::frame>(this);
  core.keep(state_);
}

void UsbHost::reset(Cycle at) {
  if (state_.phase == Phase::open) core_.environment.listens(line(), 0, at);
  state_ = {};
}

void UsbHost::clock_runs(bool runs, Cycle at) {
  core_.hold_or_go_on(act_, state_.held_act, runs, at);
  core_.hold_or_go_on(frame_, state_.held_frame, runs, at);
}

void UsbHost::attachment_changed() {
  const bool attached = device_.is_attached();
  if (attached == (state_.phase != Phase::absent)) return;
  if (!attached) {
    reset(core_.now());
    core_.events.cancel(act_);
    return core_.events.cancel(frame_);
  }
  state_.phase = Phase::debouncing;
  core_.schedule(act_, core_.now() + core_.cycles(kDebounce_ns));
}

void UsbHost::filled() {
  if (core_.events.due(act_) == kNoCycle && state_.phase == Phase::open)
    core_.schedule(act_, core_.now() + core_.cycles(kTransaction_ns));
}

void UsbHost::frame(Cycle at) {
  device_.frame_began();
  core_.schedule(frame_, at + core_.cycles(kMillisecond_ns));
}

void UsbHost::act(Cycle at) {
  std::int64_t next_ns = kTransaction_ns;
  switch (state_.phase) {
    case Phase::debouncing:
      state_.phase = Phase::resetting;
      next_ns = kReset_ns;
      break;
    case Phase::resetting:
      state_.phase = Phase::recovering;
      device_.bus_was_reset();
      core_.schedule(frame_, at + core_.cycles(kMillisecond_ns));
      next_ns = kReset_ns;
      break;
    case Phase::recovering:
      state_.phase = Phase::asking;
      break;
    case Phase::asking:
      ask();
      if (state_.stage == Stage::setup)
        next_ns = kMillisecond_ns;  // pauses after each request, so that a new address can take effect
      break;
    case Phase::open:
      return move_bytes(at);
    default:
      return;
  }
  if (state_.phase != Phase::refused) core_.schedule(act_, at + core_.cycles(next_ns));
}

UsbHost::Request UsbHost::request() const {
  const auto& have = state_.descriptors;
  switch (state_.step) {
    case kDevice:
      return {kToHost, kGetDescriptor, kDeviceDescriptor, 0, 18};
    case kAddress:
      return {0, kSetAddress, 1, 0, 0};
    case kConfigurationHead:
      return {kToHost, kGetDescriptor, kConfigurationDescriptor, 0, 9};
    case kConfiguration: {
      const int length = have[2] | have[3] << 8;
      return {kToHost, kGetDescriptor, kConfigurationDescriptor, 0,
              static_cast<std::uint16_t>(std::min<int>(length, kMostDescriptors))};
    }
    case kConfigure:
      return {0, kSetConfiguration, state_.configuration, 0, 0};
    case kLineCoding:
      return {kOfInterface, kSetLineCoding, 0, state_.control_interface, kCoding.size()};
    default:
      return {kOfInterface, kSetControlLineState, kReady, state_.control_interface, 0};
  }
}

void UsbHost::ask() {
  const Request wanted = request();
  UsbDevice::Packet packet;
  Answer answer = Answer::done;
  switch (state_.stage) {
    case Stage::setup: {
      const auto low = [](int word) { return static_cast<std::uint8_t>(word); };
      device_.setup({wanted.type, wanted.request, low(wanted.value), low(wanted.value >> 8),
                     low(wanted.index), low(wanted.index >> 8), low(wanted.length), low(wanted.length >> 8)});
      state_.received = 0;
      state_.stage = wanted.type & kToHost ? Stage::in : wanted.length > 0 ? Stage::out : Stage::status_in;
      return;
    }
    case Stage::in: {
      answer = device_.take(0, packet);
      if (answer != Answer::done) break;
      const auto room = static_cast<std::uint16_t>(kMostDescriptors - state_.received);
      const std::uint16_t count = std::min<std::uint16_t>(packet.count, room);
      std::copy_n(packet.bytes.begin(), count, state_.descriptors.begin() + state_.received);
      state_.received = static_cast<std::uint16_t>(state_.received + count);
      if (packet.count < UsbDevice::kMostBytes || state_.received >= wanted.length)
        state_.stage = Stage::status_out;
      return;
    }
    case Stage::out:
      std::copy(kCoding.begin(), kCoding.end(), packet.bytes.begin());
      packet.count = kCoding.size();
      answer = device_.give(0, packet);
      if (answer == Answer::done) state_.stage = Stage::status_in;
      break;
    case Stage::status_in:
      answer = device_.take(0, packet);
      if (answer == Answer::done) answered();
      break;
    case Stage::status_out:
      answer = device_.give(0, packet);
      if (answer == Answer::done) answered();
      break;
  }
  if (answer == Answer::stall) state_.phase = Phase::refused;
}

void UsbHost::answered() {
  state_.stage = Stage::setup;
  if (state_.step == kConfiguration) read_descriptors();
  if (++state_.step == kConfigure + 1 && state_.data_in == 0) state_.phase = Phase::refused;
  if (state_.step < kSteps) return;
  state_.phase = Phase::open;
  core_.environment.listens(line(), core_.cycles(kByte_ns), core_.now());
}

// Finds the serial port in the descriptors: an interface of class 2, and the endpoints of an interface of
// class 10.
void UsbHost::read_descriptors() {
  const auto& have = state_.descriptors;
  state_.configuration = have[5];
  int interface_class = 0;
  for (std::size_t at = 0; at + 6 < state_.received && have[at] > 0; at += have[at]) {
    if (have[at + 1] == kInterface) {
      interface_class = have[at + 5];
      if (interface_class == kCommunication) state_.control_interface = have[at + 2];
    } else if (have[at + 1] == kEndpoint && interface_class == kData) {
      (have[at + 2] & kIn ? state_.data_in : state_.data_out) = have[at + 2] & 7;
    }
  }
}

void UsbHost::receive(std::uint8_t byte) {
  if (state_.phase != Phase::open || state_.count == kMostWaiting) return;
  state_.waiting[(state_.first + state_.count++) % kMostWaiting] = byte;
  filled();
}

void UsbHost::move_bytes(Cycle at) {
  UsbDevice::Packet packet;
  bool more = device_.take(state_.data_in, packet) == Answer::done;
  for (std::size_t i = 0; more && i < packet.count; ++i) core_.environment.sent(line(), packet.bytes[i], at);
  if (state_.count > 0) {
    const auto count = std::min<std::uint16_t>(state_.count, UsbDevice::kMostBytes);
    for (std::uint16_t i = 0; i < count; ++i)
      packet.bytes[i] = state_.waiting[(state_.first + i) % kMostWaiting];
    packet.count = static_cast<std::uint8_t>(count);
    if (device_.give(state_.data_out, packet) == Answer::done) {
      state_.first = static_cast<std::uint16_t>((state_.first + count) % kMostWaiting);
      state_.count = static_cast<std::uint16_t>(state_.count - count);
    }
    more = true;
  }
  if (more) core_.schedule(act_, at + core_.cycles(kTransaction_ns));
}

}  // namespace robosim::avr
