#include "sim/exec/avr/board_adapter.h"

namespace robosim::exec::avr {
namespace {

constexpr Cycle kClockRounding = 2;  // largest error, in cycles, of a converted time

bool is_same_place(const ChipPin& a, const ChipPin& b) {
  return a.port == b.port && a.bit == b.bit && a.analog_channel == b.analog_channel;
}

}  // namespace

BoardAdapter::BoardAdapter(ClockedBoard& board, SimTime began)
    : board_(board),
      pins_(board.spec().chip->pin_count, kNoPin),
      chip_pins_(board.spec().pin_count, -1),
      serial_(board.spec().serial_line),
      state_{ClockMap(board.spec().clock_hz, began)} {
  const BoardSpec& spec = board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin)
    for (int place = 0; place < spec.chip->pin_count; ++place)
      if (first_number(spec, pin) == pin && is_same_place(spec.pins[pin].chip_pin, spec.chip->pins[place])) {
        pins_[static_cast<std::size_t>(place)] = pin;
        chip_pins_[pin] = place;
      }
}

Pin BoardAdapter::last_read() const {
  const int pin = chip_->pins().last_read();
  return pin < 0 ? kNoPin : pins_[static_cast<std::size_t>(pin)];
}

void BoardAdapter::take_waiting(Cycle now) {
  BoardInput input;
  while (board_.take_input(state_.clock_map.time_of(now), input)) {
    if (input.kind == BoardInput::Kind::byte) {
      chip_->receive(serial_, input.value, now);
    } else if (chip_pins_[input.pin] >= 0) {
      chip_->edge(chip_pins_[input.pin], input.value, now);
    }
  }
  expect_input();
}

void BoardAdapter::expect_input() {
  const SimTime next = board_.next_input();
  if (next == state_.expected || !chip_) return;
  state_.expected = next;
  chip_->call_at(next == kNever ? robosim::avr::kNoCycle : state_.clock_map.cycle_at(next));
}

bool BoardAdapter::level(int pin, bool pull_up, Cycle at, ReadIntent intent) {
  const Pin number = pins_[static_cast<std::size_t>(pin)];
  return number == kNoPin ? pull_up : board_.read_level(number, state_.clock_map.time_of(at), intent);
}

Cycle BoardAdapter::level_until(int pin, Cycle at) {
  const Pin number = pins_[static_cast<std::size_t>(pin)];
  if (number == kNoPin) return robosim::avr::kNoCycle;
  const SimTime until = board_.same_until(number, state_.clock_map.time_of(at));
  if (until == kNever) return robosim::avr::kNoCycle;
  const Cycle cycle = state_.clock_map.cycle_at(until);
  return cycle > at + kClockRounding ? cycle - kClockRounding : at;
}

Source BoardAdapter::source(int pin, bool high, Cycle at) {
  const Pin number = pins_[static_cast<std::size_t>(pin)];
  if (number == kNoPin) return high ? supply_volts() : 0.0;
  return board_.read_source(number, state_.clock_map.time_of(at));
}

void BoardAdapter::driven(int pin, const PinDrive& drive, Cycle at) {
  const Pin number = pins_[static_cast<std::size_t>(pin)];
  if (number == kNoPin) return;
  board_.set_drive(number, drive, state_.clock_map.time_of(at));
  expect_input();
}

bool BoardAdapter::wants_edges(int pin, bool wanted, Cycle at) {
  const Pin number = pins_[static_cast<std::size_t>(pin)];
  if (number == kNoPin || (!wanted && !board_.wants_edges(number))) return false;
  const bool found = board_.set_wants_edges(number, wanted, state_.clock_map.time_of(at));
  expect_input();
  return found;
}

void BoardAdapter::sent(int line, std::uint16_t data, Cycle at) {
  if (line != serial_) return;
  board_.send_byte(static_cast<std::uint8_t>(data), state_.clock_map.time_of(at));
  expect_input();
}

void BoardAdapter::listens(int line, Cycle frame, Cycle at) {
  if (line != serial_) return;
  state_.frame = frame;
  board_.listen(state_.clock_map.length_of(frame), state_.clock_map.time_of(at));
  expect_input();
}

void BoardAdapter::clock_divided(int divisor, Cycle at) {
  state_.clock_map.divide(divisor, at);
  if (state_.frame != 0)
    board_.listen(state_.clock_map.length_of(state_.frame), state_.clock_map.time_of(at));
  state_.expected = kNever;
  expect_input();
  chip_->cpu().stop();  // the end of the tick is now at another cycle
}

void BoardAdapter::write_eeprom(std::uint16_t address, std::uint8_t value, Cycle at) {
  board_.write_eeprom(address, value, state_.clock_map.time_of(at));
}

}  // namespace robosim::exec::avr
