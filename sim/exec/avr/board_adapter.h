// Connects the chip to a board: maps the chip's pins to the board's pins, and cycles to the board's time.
#pragma once

#include <vector>

#include "sim/exec/avr/clock_map.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/mcu/avr/chip.h"
#include "sim/mcu/avr/chip_environment.h"

namespace robosim::exec::avr {

class BoardAdapter : public robosim::avr::ChipEnvironment {
 public:
  BoardAdapter(ClockedBoard& board, SimTime began);

  /// Connects the chip. Must be called before all other functions.
  void plug_in(robosim::avr::Chip& chip) { chip_ = &chip; }
  /// Passes to the chip the inputs that have arrived by `now`. Makes the chip call this function again,
  /// through called(), when the next input arrives.
  void take_inputs(Cycle now) {
    state_.expected = kNever;
    if (board_.next_input() != kNever) take_waiting(now);
  }

  const ClockMap& clock_map() const { return state_.clock_map; }
  /// Returns the chip's pin for a pin of the board; -1 = none.
  int chip_pin(Pin pin) const { return chip_pins_[pin]; }
  /// Returns the board's pin for a pin of the chip; kNoPin = none.
  Pin board_pin(int pin) const { return pins_[static_cast<std::size_t>(pin)]; }
  /// Return the board's pin that the firmware read last, and the cycle of that read. The pin is kNoPin if the
  /// firmware has not read a pin yet.
  Pin last_read() const;
  Cycle last_read_at() const { return chip_->pins().last_read_at(); }
  /// Returns the board's pin if the last reads all read this pin (InputReads::only_pin()); else kNoPin.
  Pin only_read() const {
    const Pin pin = chip_->pins().reads().only_pin();
    return pin == kNoPin ? kNoPin : board_pin(pin);
  }

  /// All state that changes while the chip runs.
  struct State {
    ClockMap clock_map;
    SimTime expected = kNever;  ///< time at which the next input arrives
    Cycle frame = 0;            ///< duration of a received frame in cycles; 0 = the receiver is off
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  bool level(int pin, bool pull_up, Cycle at, ReadIntent intent) override;
  Cycle level_until(int pin, Cycle at) override;
  Source source(int pin, bool high, Cycle at) override;
  double supply_volts() const override { return board_.supply_volts(); }
  void driven(int pin, const PinDrive& drive, Cycle at) override;
  bool wants_edges(int pin, bool wanted, Cycle at) override;
  void sent(int line, std::uint16_t data, Cycle at) override;
  void listens(int line, Cycle frame, Cycle at) override;
  bool two_wire_address(std::uint8_t address, Cycle at) override {
    return board_.two_wire_address(address, state_.clock_map.time_of(at));
  }
  bool two_wire_write(std::uint8_t byte, Cycle at) override {
    return board_.two_wire_write(byte, state_.clock_map.time_of(at));
  }
  std::uint8_t two_wire_read(Cycle at) override { return board_.two_wire_read(state_.clock_map.time_of(at)); }
  void two_wire_stop(Cycle at) override { board_.two_wire_stop(state_.clock_map.time_of(at)); }
  std::uint8_t read_eeprom(std::uint16_t address) const override { return board_.read_eeprom(address); }
  void write_eeprom(std::uint16_t address, std::uint8_t value, Cycle at) override;
  void called(Cycle at) override { take_inputs(at); }
  void clock_divided(int divisor, Cycle at) override;

  void take_waiting(Cycle now);
  void expect_input();

  ClockedBoard& board_;
  robosim::avr::Chip* chip_ = nullptr;
  std::vector<Pin> pins_;       ///< the board's pin for each pin of the chip; kNoPin = not connected
  std::vector<int> chip_pins_;  ///< the chip's pin for each pin of the board; -1 = none
  const int serial_;            ///< number of the chip's serial line that is connected to the computer
  State state_;
};

}  // namespace robosim::exec::avr
