// Provides a board without firmware, whose pins the tests drive and read.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "hal/board/firmware_port.h"
#include "hal/board/robot_port.h"

namespace robosim::robot {

class FakeBoard final : public FirmwarePort, public RobotPort {
 public:
  explicit FakeBoard(const BoardSpec& spec) : spec_(spec) {}

  struct Edge {
    Pin pin;
    bool level;
    SimTime at;
    bool operator==(const Edge&) const = default;
  };
  std::vector<Edge> edges;    ///< scheduled edges, except those that repeat a level
  bool edges_wanted = false;  ///< the result of wants_edges()

  void output(Pin pin, bool level, SimTime t) { set_drive(pin, PinDrive::constant(level), t); }
  void pwm(Pin pin, double duty, SimTime t) { set_drive(pin, {PinMode::output, false, true, duty, 0}, t); }
  void input(Pin pin, bool pullup, SimTime t) {
    PinDrive drive;
    drive.mode = pullup ? PinMode::input_pullup : PinMode::input;
    set_drive(pin, drive, t);
  }
  /// Attaches an interrupt to `pin`: sets `edges_wanted`, and reads the pin's level, as the chip does.
  void want_edges(Pin pin, SimTime t) {
    edges_wanted = true;
    levels_[pin] = read_level(pin, t);
  }
  bool connected(Pin pin) const { return sources_[pin] != nullptr; }

  const BoardSpec& spec() const override { return spec_; }
  void set_drive(Pin pin, const PinDrive& drive, SimTime t) override {
    if (drives_[pin] == drive) return;
    drives_[pin] = drive;
    for (PinWatcher* watcher : watchers_[pin]) watcher->pin_changed(pin, drive, t);
  }
  bool read_level(Pin pin, SimTime t, ReadIntent = ReadIntent::pin) override {
    return sources_[pin] ? sources_[pin]->level(t) : pulled_up(pin);
  }
  SimTime same_until(Pin pin, SimTime t) const { return sources_[pin]->same_until(t); }
  Source read_source(Pin pin, SimTime t) override {
    if (sources_[pin]) return sources_[pin]->output(t, *supply_volts_);
    return pulled_up(pin) ? *supply_volts_ : 0.0;
  }
  const double& supply_volts() const override { return *supply_volts_; }
  void send_byte(uint8_t, SimTime) override {}
  bool two_wire_address(uint8_t address, SimTime t) override {
    two_wire_stop(t);
    for (TwoWireDevice* device : two_wire_)
      if (!spoken_to_ && device->address(static_cast<uint8_t>(address >> 1), address & 1, t))
        spoken_to_ = device;
    return spoken_to_;
  }
  bool two_wire_write(uint8_t byte, SimTime t) override { return spoken_to_ && spoken_to_->write(byte, t); }
  uint8_t two_wire_read(SimTime t) override { return spoken_to_ ? spoken_to_->read(t) : 0xFF; }
  void two_wire_stop(SimTime t) override {
    if (spoken_to_) spoken_to_->stop(t);
    spoken_to_ = nullptr;
  }
  void connect(TwoWireDevice& device) override { two_wire_.push_back(&device); }
  uint8_t read_eeprom(uint16_t) const override { return 0xFF; }
  void write_eeprom(uint16_t, uint8_t, SimTime) override {}
  const PinDrive& drive(Pin pin) const override { return drives_[pin]; }
  void connect(Pin pin, PinSource& source) override { sources_[pin] = &source; }
  void feed(const double& volts) override { supply_volts_ = &volts; }
  void watch(Pin pin, PinWatcher& watcher) override { watchers_[pin].push_back(&watcher); }
  void watch_serial(SerialWatcher&) override {}
  void watch_eeprom(EepromWatcher&) override {}
  void schedule_edge(Pin pin, bool level, SimTime at) override {
    if (levels_[pin] != level) edges.push_back({pin, level, at});
    levels_[pin] = level;
  }
  bool wants_edges(Pin) const override { return edges_wanted; }
  bool wants_any_edges() const override { return edges_wanted; }
  void receive_byte(uint8_t, SimTime) override {}
  void watch_inputs(InputWatcher&) override {}

 private:
  bool pulled_up(Pin pin) const { return drives_[pin].mode == PinMode::input_pullup; }

  const BoardSpec& spec_;
  const double* supply_volts_ = &spec_.supply_volts;
  std::array<std::optional<bool>, kMaxPins> levels_{};  ///< the last level that the board has seen
  std::array<PinDrive, kMaxPins> drives_{};
  std::array<PinSource*, kMaxPins> sources_{};
  std::vector<TwoWireDevice*> two_wire_;
  TwoWireDevice* spoken_to_ = nullptr;
  std::array<std::vector<PinWatcher*>, kMaxPins> watchers_;
};

}  // namespace robosim::robot
