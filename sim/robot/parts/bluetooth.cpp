#include "sim/robot/parts/bluetooth.h"

#include <algorithm>

#include "hal/board/board_spec.h"

namespace robosim::robot {
namespace {

constexpr int kFrameBits = 10;  // start, 8, stop
constexpr std::size_t kLongestLine = 200;
constexpr std::size_t kMostLines = 100;            // that wait to be told, one in each tick
constexpr SimTime kLineEnds = 200 * kMillisecond;  // without another byte

constexpr FaultKind kBluetoothFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "nothing arrives on either side"},
};

/// Whether the two pins are those of the board's Serial.
bool is_serial(const BoardSpec& board, Pin rx, Pin tx) {
  const ChipSpec& chip = *board.chip;
  if (board.serial_line >= chip.uart_count) return false;
  const UartSpec& uart = chip.uarts[board.serial_line];
  return rx == find_pin(board, uart.rx) && tx == find_pin(board, uart.tx);
}

}  // namespace

std::shared_ptr<const PartSpec> read_bluetooth(PartReader& reader) {
  auto spec = std::make_shared<BluetoothSpec>();
  std::size_t wiring = 0;
  const std::vector<Pin> pins = reader.pin_table({{"txd", "rxd"}, {"txd"}}, wiring);
  spec->txd = pins[0];
  if (wiring == 0) spec->rxd = pins[1];
  spec->baud = reader.table().integer("baud", 9600, 300, 115200);
  return reader.finish(spec);
}

std::unique_ptr<Part> BluetoothSpec::make(PartContext& context) const {
  return std::make_unique<BluetoothPart>(*this, context);
}

BluetoothPart::BluetoothPart(const BluetoothSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      on_uart_(is_serial(*context.description.board, spec.txd, spec.rxd)),
      bit_(kSecond / spec.baud),
      supply_(context.description.board->supply_volts) {
  context.kept.add(state_);
}

void BluetoothPart::join(Roster& roster) {
  roster.breakable.push_back(this);
  roster.receivers.push_back(this);
  roster.tellers.push_back(this);
  if (on_uart_) {
    context_.board.watch_serial(*this);
    return;
  }
  context_.board.connect(spec_.txd, *this);
  if (spec_.rxd != kNoPin) context_.board.watch(spec_.rxd, *this);
  roster.ticking.push_back(this);
}

void BluetoothPart::send(const Message& message, SimTime t) {
  if (state_.dead) return;
  for (const char c : message.text) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (on_uart_)
      context_.board.receive_byte(byte, t);
    else
      send_byte(byte, t);
  }
}

void BluetoothPart::send_byte(std::uint8_t byte, SimTime t) {
  // Of the last byte only the end of its low bits is in the train: its stop bit may follow.
  const SimTime begin = std::max(t, state_.free_at);
  const std::uint32_t frame = byte << 1 | 1u << 9;
  bool level = true;
  for (int i = 0; i < kFrameBits; ++i) {
    const bool bit = frame >> i & 1;
    if (bit != level) state_.line.flip(begin + i * bit_);
    level = bit;
  }
  state_.free_at = begin + kFrameBits * bit_;
}

void BluetoothPart::begin_tick(SimTime t) {
  if (!state_.line.empty()) state_.line.begin_tick(context_.board, spec_.txd, t);
  listen(t);
}

void BluetoothPart::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  listen(t);
  state_.high = drive.mode != PinMode::output || drive.level;
  if (state_.began != kNever || state_.high) return;
  state_.began = t;
  state_.bits = 0;
  state_.frame = 0;
}

void BluetoothPart::listen(SimTime t) {
  while (state_.began != kNever && state_.began + state_.bits * bit_ + bit_ / 2 < t) {
    state_.frame |= static_cast<std::uint32_t>(state_.high) << state_.bits;
    if (++state_.bits < kFrameBits) continue;
    const bool sound = (state_.frame & 1) == 0 && (state_.frame >> 9 & 1) == 1;
    take(sound ? static_cast<std::uint8_t>(state_.frame >> 1) : '?', t);
    state_.began = kNever;
  }
}

void BluetoothPart::take(std::uint8_t byte, SimTime t) {
  if (state_.dead || byte == '\r') return;
  state_.heard_at = t;
  if (byte != '\n') state_.heard += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '?';
  if (byte != '\n' && state_.heard.size() < kLongestLine) return;
  if (!state_.heard.empty() && state_.lines.size() < kMostLines) state_.lines.push_back(state_.heard);
  state_.heard.clear();
}

std::string BluetoothPart::tell(SimTime t) {
  if (!state_.heard.empty() && t - state_.heard_at >= kLineEnds) take('\n', t);
  if (state_.lines.empty()) return {};
  std::string line = std::move(state_.lines.front());
  state_.lines.erase(state_.lines.begin());
  return line;
}

void BluetoothPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.line.empty() ? 0.0 : 1.0});
}

std::span<const FaultKind> BluetoothPart::fault_kinds() const { return kBluetoothFaults; }

void BluetoothPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
