// type = "serial-radio": a wireless serial line (HC-12, APC220 and similar). Each byte that the sketch sends
// reaches all other serial-radios on its channel after `delay`. Each of them loses the byte with the
// probability `loss`. A script's `send` acts as another sender. serial_line.h describes the serial line to
// the board.
//
// The HC-12's manual states delays of 4 to 80 ms, depending on mode and baud rate; the default of 20 ms is
// between them. Not modelled: range, byte collisions, packets, AT commands.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/serial_line.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_serial_radio(PartReader&);

class SerialRadioSpec final : public PartSpec {
 public:
  SerialWiring wiring;
  Parameter delay;  ///< s
  Parameter loss;   ///< 0..1
  int channel = 1;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class SerialRadioPart final : public Part, public Receiver, public Breakable {
 public:
  SerialRadioPart(const SerialRadioSpec&, PartContext&);

  void check(const Message&) const override {}
  void send(const Message&, SimTime) override;
  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  struct State {
    std::uint64_t arrived = 0;  // number of bytes, including lost bytes
    bool dead = false;
  };

  const SerialRadioSpec& spec_;
  world::RadioChannel& radio_;
  const std::size_t number_;  ///< number of this radio among the senders
  const SimTime delay_;
  const double loss_;
  const NoiseStream losses_;
  SerialLine line_;
  State state_;
};

}  // namespace robosim::robot
