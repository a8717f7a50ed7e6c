#include "sim/robot/parts/serial_line.h"

#include <algorithm>
#include <utility>

#include "hal/board/board_spec.h"

namespace robosim::robot {
namespace {

constexpr int kFrameBits = 10;  // start, 8, stop

/// Returns whether the two pins are those of the board's Serial.
bool is_serial(const BoardSpec& board, Pin rx, Pin tx) {
  const ChipSpec& chip = *board.chip;
  if (board.serial_line >= chip.uart_count) return false;
  const UartSpec& uart = chip.uarts[board.serial_line];
  return rx == find_pin(board, uart.rx) && tx == find_pin(board, uart.tx);
}

}  // namespace

SerialWiring read_serial_wiring(PartReader& reader) {
  SerialWiring wiring;
  std::size_t which = 0;
  const std::vector<Pin> pins = reader.pin_table({{"txd", "rxd"}, {"txd"}}, which);
  wiring.txd = pins[0];
  if (which == 0) wiring.rxd = pins[1];
  wiring.baud = reader.table().integer("baud", 9600, 300, 115200);
  return wiring;
}

SerialLine::SerialLine(const SerialWiring& wiring, PartContext& context, Heard heard)
    : wiring_(wiring),
      context_(context),
      heard_(std::move(heard)),
      on_uart_(is_serial(*context.description.board, wiring.txd, wiring.rxd)),
      bit_(kSecond / wiring.baud) {
  context.snapshots.add(state_);
}

void SerialLine::register_with(Part& owner, PartRegistry& registry) {
  if (on_uart_) {
    context_.board.watch_serial(*this);
    return;
  }
  context_.board.connect(wiring_.txd, *this);
  if (wiring_.rxd != kNoPin) context_.board.watch(wiring_.rxd, *this);
  registry.ticking.push_back(&owner);
}

void SerialLine::send(std::uint8_t byte, SimTime t) {
  if (on_uart_) {
    context_.board.receive_byte(byte, t);
    return;
  }
  // Waits for the end of the last stop bit, which has no edge in the pulse train.
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

void SerialLine::begin_tick(SimTime t) {
  if (!state_.line.empty()) state_.line.begin_tick(context_.board, wiring_.txd, t);
  listen(t);
}

void SerialLine::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  listen(t);
  state_.high = drive.mode != PinMode::output || drive.level;
  if (state_.began != kNever || state_.high) return;
  state_.began = t;
  state_.bits = 0;
  state_.frame = 0;
}

void SerialLine::listen(SimTime t) {
  while (state_.began != kNever && state_.began + state_.bits * bit_ + bit_ / 2 < t) {
    state_.frame |= static_cast<std::uint32_t>(state_.high) << state_.bits;
    if (++state_.bits < kFrameBits) continue;
    const bool sound = (state_.frame & 1) == 0 && (state_.frame >> 9 & 1) == 1;
    heard_(static_cast<std::uint8_t>(state_.frame >> 1), sound, t);
    state_.began = kNever;
  }
}

}  // namespace robosim::robot
