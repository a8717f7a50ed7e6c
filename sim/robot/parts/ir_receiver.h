// type = "ir-receiver": a demodulator for remote controls (TSOP38238, VS1838B), and the remote control
// itself. `send ir 0x45` in a script presses the remote's key 0x45, and `send ir 0x45 for 500ms` holds the
// key.
//
// The receiver outputs the NEC protocol: high at rest, low while there is light.
//
//   low 9 ms, high 4.5 ms, 32 bits, low 562.5 us; a bit: low 562.5 us, high 562.5 us (0) or 1687.5 us (1)
//   while the key is held: every 108 ms, low 9 ms, high 2.25 ms, low 562.5 us
//
// The 32 bits are address, inverted address, command and inverted command, each byte with its lowest bit
// first. Source: SB-Projects and Vishay application note 80071, "Data Formats for IR Remote Control".
//
// Not modelled: carrier, distance, sunlight, and the stretching of pulses by the receiver (some 10 us).
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/pulse_train.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ir_receiver(PartReader&);

class IrReceiverSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  std::uint8_t address = 0;  ///< address of the remote control

  std::unique_ptr<Part> make(PartContext&) const override;
};

class IrReceiverPart final : public Part, public PinSource, public Receiver, public Breakable {
 public:
  IrReceiverPart(const IrReceiverSpec&, PartContext&);

  void check(const Message&) const override;
  void send(const Message&, SimTime) override;

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  bool level(SimTime t) override { return state_.line.level(t); }
  SimTime same_until(SimTime t) override { return state_.line.same_until(t); }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  struct State {
    PulseTrain line{true};
    bool dead = false;
  };

  const IrReceiverSpec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
