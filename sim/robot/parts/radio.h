// type = "radio": a receiver that outputs a remote control's messages bit by bit, on three pins that the
// sketch reads. Scripts send messages: `at 20s send radio 3`.
//
// One message of n bits, each `bit` long:
//
//   enable  ___/‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾\___   high during the message, and half a bit before and after
//   data    ----< b1  >< b2  >< b3  >----   stable for the whole bit; low between messages
//   clock   _______/‾‾\__/‾‾\__/‾‾\______   rises in the middle of each bit
//
// If a script sends a message during another one, the new message begins one bit after the end of the other.
// The default of 1 ms per bit suits 433 MHz modules for hobbyists (1 to 2 kbit/s). The fault `noisy` inverts
// bits. Not modelled: range, other senders and damaged preambles.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_radio(PartReader&);

class RadioSpec final : public PartSpec {
 public:
  Pin data = kNoPin;
  Pin clock = kNoPin;
  Pin enable = kNoPin;
  Parameter bit;  ///< s, duration of a bit

  std::unique_ptr<Part> make(PartContext&) const override;
};

class RadioPart final : public Part, public Receiver, public Breakable {
 public:
  RadioPart(const RadioSpec&, PartContext&);

  /// Accepts a byte such as "3", which is sent most significant bit first, or up to 64 bits such as "0b101".
  /// Throws InputError for other messages.
  void check(const Message&) const override;
  void send(const Message&, SimTime) override;

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  enum Line { data, clock, enable };
  /// A level change of a line.
  struct Change {
    SimTime at;
    Line line;
    bool level;
  };
  class Output final : public PinSource {
   public:
    Output(RadioPart& radio, Line line) : radio_(radio), line_(line) {}
    bool level(SimTime t) override { return radio_.level(line_, t); }

   private:
    RadioPart& radio_;
    const Line line_;
  };

  bool level(Line line, SimTime t) const;
  Pin pin_of(Line line) const;

  struct State {
    std::uint64_t bits_sent = 0;
    std::vector<Change> changes;  // level changes of the transmitted messages, by time
    std::size_t announced = 0;    // number of changes that have been scheduled
    SimTime free_at = 0;          // earliest beginning of the next message
    bool dead = false;
    double turned = 0.0;  // share of bits that arrive inverted
  };

  const RadioSpec& spec_;
  PartContext& context_;
  Output outputs_[3];
  const NoiseStream stream_;
  const SimTime bit_;
  State state_;
};

}  // namespace robosim::robot
