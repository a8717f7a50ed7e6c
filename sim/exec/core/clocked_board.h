// Connects an executor to the board. The executor measures all times by the firmware's own clock, which may
// drift. The board measures all times by the world's clock. Only this class converts between the two clocks.
#pragma once

#include <algorithm>

#include "sim/exec/core/board_state.h"
#include "sim/exec/core/firmware_clock.h"

namespace robosim::exec {

class ClockedBoard final : public FirmwarePort {
 public:
  explicit ClockedBoard(BoardState& board) : board_(board) {}

  // --- for executors; `world` and `end` are times by the world's clock, all others by the firmware's clock
  /// Begins a tick that ends at `end`. Returns `end` by the firmware's clock. If an instruction begins before
  /// `end` and ends after `end`, its effects appear in the world at `end`.
  SimTime begin_tick(SimTime end) {
    state_.limit = end;
    return state_.clock.to_firmware(end);
  }
  SimTime to_firmware(SimTime world) const { return state_.clock.to_firmware(world); }
  SimTime to_world(SimTime t) const { return state_.clock.to_world(t); }
  /// Makes the firmware's clock too fast by `ppm` parts per million from `world` on.
  void drift(int ppm, SimTime world) { state_.clock.drift(ppm, world); }

  bool wants_edges(Pin pin) const { return board_.wants_edges(pin); }
  bool set_wants_edges(Pin pin, bool wanted, SimTime now) {
    return board_.set_wants_edges(pin, wanted, at(now));
  }
  void set_drive_heard(Pin pin, const PinDrive& drive, SimTime t) {
    board_.set_drive_heard(pin, drive, at(t));
  }
  void listen(SimTime byte_time, SimTime now) { board_.listen(byte_time, at(now)); }
  SimTime same_until(Pin pin, SimTime t) const {
    return state_.clock.to_firmware(board_.same_until(pin, at(t)));
  }
  SimTime next_input() const { return state_.clock.to_firmware(board_.next_input()); }
  bool take_input(SimTime until, BoardInput& input) {
    if (!board_.take_input(state_.clock.to_world(until), input)) return false;
    input.at = state_.clock.to_firmware(input.at);
    return true;
  }

  struct State {
    FirmwareClock clock;
    SimTime limit = kNever;
  };
  /// Returns the state of this object, without the state of the board.
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

  // --- FirmwarePort
  const BoardSpec& spec() const override { return board_.spec(); }
  void set_drive(Pin pin, const PinDrive& drive, SimTime t) override { board_.set_drive(pin, drive, at(t)); }
  bool read_level(Pin pin, SimTime t, ReadIntent intent = ReadIntent::pin) override {
    return board_.read_level(pin, at(t), intent);
  }
  Source read_source(Pin pin, SimTime t) override { return board_.read_source(pin, at(t)); }
  const double& supply_volts() const override { return board_.supply_volts(); }
  void send_byte(std::uint8_t byte, SimTime t) override { board_.send_byte(byte, at(t)); }
  bool two_wire_address(std::uint8_t address, SimTime t) override {
    return board_.two_wire_address(address, at(t));
  }
  bool two_wire_write(std::uint8_t byte, SimTime t) override { return board_.two_wire_write(byte, at(t)); }
  std::uint8_t two_wire_read(SimTime t) override { return board_.two_wire_read(at(t)); }
  void two_wire_stop(SimTime t) override { board_.two_wire_stop(at(t)); }
  std::uint8_t read_eeprom(std::uint16_t address) const override { return board_.read_eeprom(address); }
  void write_eeprom(std::uint16_t address, std::uint8_t value, SimTime t) override {
    board_.write_eeprom(address, value, at(t));
  }

 private:
  SimTime at(SimTime t) const { return std::min(state_.clock.to_world(t), state_.limit); }

  BoardState& board_;
  State state_;
};

}  // namespace robosim::exec
