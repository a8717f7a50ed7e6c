// The board as firmware sees it whose clock differs from the world's: every time it gives is translated.
#pragma once

#include "sim/exec/core/board_state.h"
#include "sim/exec/core/firmware_clock.h"

namespace robosim::exec {

/// Only what firmware calls; what belongs to the robot's side is passed on as it is.
class ClockedBoard final : public Board {
 public:
  ClockedBoard(BoardState& board, const FirmwareClock& clock) : board_(board), clock_(clock) {}

  const BoardSpec& spec() const override { return board_.spec(); }
  void set_drive(Pin pin, const PinDrive& drive, SimTime t) override {
    board_.set_drive(pin, drive, clock_.to_world(t));
  }
  bool read_level(Pin pin, SimTime t) override { return board_.read_level(pin, clock_.to_world(t)); }
  double read_volts(Pin pin, SimTime t) override { return board_.read_volts(pin, clock_.to_world(t)); }
  void send_byte(std::uint8_t byte, SimTime t) override { board_.send_byte(byte, clock_.to_world(t)); }
  std::uint8_t* eeprom() override { return board_.eeprom(); }
  void write_eeprom(std::uint16_t address, std::uint8_t value, SimTime t) override {
    board_.write_eeprom(address, value, clock_.to_world(t));
  }

  const PinDrive& drive(Pin pin) const override { return board_.drive(pin); }
  void connect(Pin pin, PinSource& source) override { board_.connect(pin, source); }
  void watch(Pin pin, PinWatcher& watcher) override { board_.watch(pin, watcher); }
  void watch_serial(SerialWatcher& watcher) override { board_.watch_serial(watcher); }
  void watch_eeprom(EepromWatcher& watcher) override { board_.watch_eeprom(watcher); }
  void schedule_edge(Pin pin, bool level, SimTime at) override { board_.schedule_edge(pin, level, at); }
  bool wants_edges(Pin pin) const override { return board_.wants_edges(pin); }
  bool wants_any_edges() const override { return board_.wants_any_edges(); }
  void receive_byte(std::uint8_t byte, SimTime at) override { board_.receive_byte(byte, at); }
  void watch_inputs(InputWatcher& watcher) override { board_.watch_inputs(watcher); }

 private:
  BoardState& board_;
  const FirmwareClock& clock_;
};

}  // namespace robosim::exec
