// Implements the simulated board, which all executors use. Firmware and robot access the board through the
// interfaces FirmwarePort and RobotPort. The board stores the drives and watchers of the pins, and the inputs
// that have not reached the chip yet. All times are measured by the world's clock.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hal/board/board_spec.h"
#include "hal/board/firmware_port.h"
#include "hal/board/robot_port.h"
#include "sim/exec/core/board_probe.h"

namespace robosim::exec {

/// An edge on a pin or a byte at the UART that has not reached the chip yet.
struct BoardInput {
  enum class Kind : std::uint8_t { edge, byte };
  Kind kind = Kind::edge;
  Pin pin = kNoPin;        ///< pin of the edge
  std::uint8_t value = 0;  ///< level after the edge, or the byte
  SimTime at = 0;          ///< time at which the input reaches the chip
};

class BoardState final : public FirmwarePort, public RobotPort, public BoardProbe {
 public:
  explicit BoardState(const BoardSpec& spec);

  const BoardSpec& spec() const override { return spec_; }

  // --- FirmwarePort
  void set_drive(Pin pin, const PinDrive& drive, SimTime t) override;
  bool read_level(Pin pin, SimTime t, ReadIntent intent = ReadIntent::pin) override;
  Source read_source(Pin pin, SimTime t) override;
  const double& supply_volts() const override { return *supply_volts_; }
  void send_byte(std::uint8_t byte, SimTime t) override;
  bool two_wire_address(std::uint8_t address, SimTime t) override;
  bool two_wire_write(std::uint8_t byte, SimTime t) override;
  std::uint8_t two_wire_read(SimTime t) override;
  void two_wire_stop(SimTime t) override;
  std::uint8_t read_eeprom(std::uint16_t address) const override { return state_.eeprom[address]; }
  void write_eeprom(std::uint16_t address, std::uint8_t value, SimTime t) override;

  // --- RobotPort
  const PinDrive& drive(Pin pin) const override { return state_of(pin).drive; }
  void connect(Pin pin, PinSource& source) override;
  void connect(TwoWireDevice& device) override { two_wire_.push_back(&device); }
  void feed(const double& volts) override { supply_volts_ = &volts; }
  void watch(Pin pin, PinWatcher& watcher) override;
  void watch_serial(SerialWatcher& watcher) override { serial_watchers_.push_back(&watcher); }
  void watch_eeprom(EepromWatcher& watcher) override { eeprom_watchers_.push_back(&watcher); }
  void schedule_edge(Pin pin, bool level, SimTime at) override;
  bool wants_edges(Pin pin) const override { return state_of(pin).wants_edges; }
  bool wants_any_edges() const override { return state_.wanted_pins > 0; }
  void receive_byte(std::uint8_t byte, SimTime at) override;
  void watch_inputs(InputWatcher& watcher) override { input_watcher_ = &watcher; }

  // --- BoardProbe
  std::span<std::uint8_t> memory() override { return state_.eeprom; }
  bool level(Pin pin, SimTime t) override { return pin < spec_.pin_count && level_on(pin, t); }
  const PinUse& use(Pin pin) const override { return state_of(pin).use; }

  // --- for executors
  /// Resets the board at `t`. All pins become inputs, requests for edges end, the receiver is turned off, and
  /// pending inputs are lost.
  void reset(SimTime t);
  /// Starts or stops reporting edges on `pin` from `now` on. If reporting starts, reads the pin on behalf of
  /// the firmware and returns the pin's level. The first edge is reported when the pin leaves this level.
  bool set_wants_edges(Pin pin, bool wanted, SimTime now);
  /// Drives a pin like set_drive(). If edges of the pin are requested, also reports a change of level to the
  /// firmware as an edge. The edges of PWM are not reported.
  void set_drive_heard(Pin pin, const PinDrive& drive, SimTime t);
  /// Turns on the receiver at `now`. Each byte takes `byte_time`; a `byte_time` of 0 turns the receiver off.
  /// Bytes that were sent before the receiver was turned on are lost.
  void listen(SimTime byte_time, SimTime now);

  /// Returns the time at which the next requested edge or byte arrives; kNever if no input is pending.
  SimTime next_input() const { return state_.next_input; }
  /// Returns the time before which all reads of `pin` return the same level as at `t`, and have no effect.
  /// Returns `t` if that time is unknown.
  SimTime same_until(Pin pin, SimTime t) const;
  /// If the next input arrives at or before `until`, moves it to `input` and returns true.
  bool take_input(SimTime until, BoardInput& input);
  /// Drops edges before `t` on pins whose edges are not requested.
  void forget_edges(SimTime t) {
    if (!state_.edges.empty()) forget_all_edges(t);
  }

  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
  struct PinState {
    PinDrive drive;
    PinUse use;
    bool wants_edges = false;
    bool last_level = false;  ///< while edges are requested: level after the last scheduled edge
  };
  struct Byte {
    std::uint8_t value;
    SimTime sent;
  };
  /// All state that changes during a run.
  struct State {
    std::vector<PinState> pins;  ///< the last element stands for all invalid pin numbers
    int wanted_pins = 0;         ///< number of pins whose edges are requested
    std::vector<std::uint8_t> eeprom;
    std::vector<BoardInput> edges;  ///< sorted by time; edges at the same time in the order of scheduling
    std::vector<Byte> bytes;        ///< sorted by time
    SimTime byte_time = 0;          ///< 0 = the receiver is off
    SimTime last_arrival = 0;
    SimTime next_input = kNever;
    std::size_t spoken_to = kNobody;  ///< index of the addressed device on the two-wire bus
  };
  const State& save() const { return state_; }
  /// Restores a saved state without notifying watchers.
  void restore(const State& saved) { state_ = saved; }

 private:
  void forget_all_edges(SimTime t);
  /// The parts that are connected to a pin.
  struct Wire {
    PinSource* source = nullptr;
    std::vector<PinWatcher*> watchers;
  };

  TwoWireDevice* spoken_to() const {
    return state_.spoken_to == kNobody ? nullptr : two_wire_[state_.spoken_to];
  }
  const Byte* next_byte() const;
  SimTime arrival(const Byte& byte) const;
  std::size_t next_edge() const;
  void refresh_next();

  const PinState& state_of(Pin pin) const { return state_.pins[std::min(pin, spec_.pin_count)]; }
  bool level_on(Pin pin, SimTime t);

  const BoardSpec& spec_;
  InputWatcher* input_watcher_ = nullptr;
  std::vector<EepromWatcher*> eeprom_watchers_;
  std::vector<Wire> wires_;  ///< indexed by pin, as State::pins
  std::vector<TwoWireDevice*> two_wire_;
  std::vector<SerialWatcher*> serial_watchers_;
  const double* supply_volts_;
  State state_;
};

}  // namespace robosim::exec
