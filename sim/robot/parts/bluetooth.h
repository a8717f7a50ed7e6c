// type = "bluetooth": a serial module (HC-05, HC-06 and their kin): a script sends lines to the sketch
// through it
// (`send bt "go\n"`), and what the sketch sends is told line by line.
//
// It sits on any two pins of the board, which the sketch drives bit by bit (SoftwareSerial, AltSoftSerial): 8
// bits, no parity, one stop bit, at `baud`. On the pins of the board's Serial (0 and 1) it is another name
// for that: bytes go through the chip's UART, and `baud` does not matter.
//
//   txd  ‾‾\_s_/b0 b1 … b7\‾‾   to the sketch, each bit 1/baud long
//   rxd  the same from the sketch; a bit is looked at in its middle. A frame whose stop bit is low is told as
//   "?"
//
// Pairing, AT commands and the way through the air are not modelled. 9600 baud is what modules have as they
// are sold (HC-03/05 serial command set).
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/pulse_train.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_bluetooth(PartReader&);

class BluetoothSpec final : public PartSpec {
 public:
  Pin txd = kNoPin;  ///< from it to the board
  Pin rxd = kNoPin;  ///< from the board; kNoPin = not wired
  std::int64_t baud = 9600;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class BluetoothPart final : public Part,
                            public PinSource,
                            public PinWatcher,
                            public SerialWatcher,
                            public Receiver,
                            public Teller,
                            public Breakable {
 public:
  BluetoothPart(const BluetoothSpec&, PartContext&);

  void check(const Message&) const override {}
  void send(const Message&, SimTime) override;
  std::string tell(SimTime) override;

  void join(Roster&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  void byte_sent(std::uint8_t byte, SimTime t) override { take(byte, t); }

  double volts(SimTime t) override { return level(t) ? supply_ : 0.0; }
  bool level(SimTime t) override { return state_.line.level(t); }
  SimTime same_until(SimTime t) override { return state_.line.same_until(t); }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  /// Takes in the bits whose middle is before `t`.
  void listen(SimTime t);
  void take(std::uint8_t byte, SimTime t);
  void send_byte(std::uint8_t byte, SimTime t);

  struct State {
    PulseTrain line{true};   // to the sketch
    SimTime free_at = 0;     // when the last byte to the sketch has ended
    bool high = true;        // what the sketch sends
    SimTime began = kNever;  // a start bit
    int bits = 0;            // so many of the frame have been looked at, the start bit too
    std::uint32_t frame = 0;
    std::string heard;               // of the line that is coming in
    SimTime heard_at = 0;            // the last byte
    std::vector<std::string> lines;  // to be told
    bool dead = false;
  };

  const BluetoothSpec& spec_;
  PartContext& context_;
  const bool on_uart_;
  const SimTime bit_;
  const double supply_;
  State state_;
};

}  // namespace robosim::robot
