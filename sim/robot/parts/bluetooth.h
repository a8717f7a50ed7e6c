// type = "bluetooth": a serial module (HC-05, HC-06 and similar). A script sends lines to the sketch through
// the module (`send bt "go\n"`). The sketch's output is reported line by line.
//
// serial_line.h describes the serial line to the board. A frame whose stop bit is low is reported as "?".
// 9600 baud is the factory setting of such modules (HC-03/05 serial command set).
//
// Not modelled: pairing, AT commands and radio transmission.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/serial_line.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_bluetooth(PartReader&);

class BluetoothSpec final : public PartSpec {
 public:
  SerialWiring wiring;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class BluetoothPart final : public Part, public Receiver, public TextOutput, public Breakable {
 public:
  BluetoothPart(const BluetoothSpec&, PartContext&);

  void check(const Message&) const override {}
  void send(const Message&, SimTime) override;
  std::string poll_text(SimTime) override;

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime t) override { line_.begin_tick(t); }
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  void take(std::uint8_t byte, SimTime t);

  struct State {
    std::string heard;               // the characters of the incomplete line
    SimTime heard_at = 0;            // time of the last byte
    std::vector<std::string> lines;  // complete lines that are not reported yet
    bool dead = false;
  };

  const BluetoothSpec& spec_;
  SerialLine line_;
  State state_;
};

}  // namespace robosim::robot
