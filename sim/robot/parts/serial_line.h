// A serial module's line to the board: 8 bits, no parity, one stop bit. The line may use any two pins, on
// which the sketch itself sends and samples each bit (SoftwareSerial, AltSoftSerial). On the pins of the
// board's Serial, bytes go through the chip's UART, and `baud` has no effect.
//
//   txd  ‾‾\_s_/b0 b1 … b7\‾‾   to the sketch, each bit 1/baud long
//   rxd  a frame of the same form, from the sketch; each bit is sampled in its middle
#pragma once

#include <functional>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/pulse_train.h"

namespace robosim::robot {

/// The wiring of a serial line, as in the part's table.
struct SerialWiring {
  Pin txd = kNoPin;  ///< from the module to the board
  Pin rxd = kNoPin;  ///< from the board; kNoPin = not wired
  std::int64_t baud = 9600;
};
/// Reads the keys `pins` and `baud`.
SerialWiring read_serial_wiring(PartReader& reader);

class SerialLine final : public PinSource, public PinWatcher, public SerialWatcher {
 public:
  /// The function that is called for each byte from the sketch. `sound` is true if the start bit was low and
  /// the stop bit was high.
  using Heard = std::function<void(std::uint8_t byte, bool sound, SimTime t)>;

  SerialLine(const SerialWiring& wiring, PartContext& context, Heard heard);

  /// Registers the line for `owner`, which must call begin_tick().
  void register_with(Part& owner, PartRegistry& registry);
  void begin_tick(SimTime t);
  /// Sends a byte to the sketch, after the pending bytes.
  void send(std::uint8_t byte, SimTime t);
  /// Returns whether nothing is pending for the sketch.
  bool idle() const { return state_.line.empty(); }

  void pin_changed(Pin, const PinDrive&, SimTime) override;
  void byte_sent(std::uint8_t byte, SimTime t) override { heard_(byte, true, t); }
  bool level(SimTime t) override { return state_.line.level(t); }
  SimTime same_until(SimTime t) override { return state_.line.same_until(t); }

 private:
  /// Reads the bits whose middle is before `t`.
  void listen(SimTime t);

  struct State {
    PulseTrain line{true};   // to the sketch
    SimTime free_at = 0;     // end of the last byte to the sketch
    bool high = true;        // the level from the sketch
    SimTime began = kNever;  // beginning of the start bit
    int bits = 0;            // number of the frame's bits so far, including the start bit
    std::uint32_t frame = 0;
  };

  const SerialWiring wiring_;
  PartContext& context_;
  const Heard heard_;
  const bool on_uart_;
  const SimTime bit_;
  State state_;
};

}  // namespace robosim::robot
