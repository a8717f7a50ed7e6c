// type = "shift-register": a 74HC595 (TI SN74HC595, SCLS041): eight outputs for three of the board's pins.
//
//   rising edge of clock   every bit moves by one, from Q0 towards Q7; the level of data enters at Q0
//   rising edge of latch   the outputs Q0 .. Q7 take the shifted bits
//   enable (OE) high       the outputs are switched off: they are not driven. Without that pin it is tied low
//
// A register with `after` follows another one in a chain: its input is that one's output, with the same
// clock, latch and enable. So of several bytes the first one shifted ends up in the last register. Other
// parts name the outputs as pins: "REG1.Q4".
//
// At power-on its contents are undefined (`typical`: random; `ideal`: zeros) until the sketch has shifted and
// latched. It shares the board's supply; while that is off, the outputs are not driven. Not modelled:
// propagation (about 20 ns) and the reset input.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

constexpr std::size_t kMostChained = 8;  ///< registers of one chain

std::shared_ptr<const PartSpec> read_shift_register(PartReader&);

/// Checks that every `after` names a register, no two the same, and that every chain begins at pins. Throws
/// InputError.
void check_chains(const Description&);

class ShiftRegisterSpec final : public PartSpec {
 public:
  int index = 0;  ///< among the robot's registers (netlist.h): its outputs are output_pin(index, 0 .. 7)
  Pin data = kNoPin;
  Pin clock = kNoPin;
  Pin latch = kNoPin;
  Pin enable = kNoPin;  ///< kNoPin = tied low
  std::string after;    ///< the previous register; empty = first of the chain, connected to pins
  Place after_place;

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// A whole chain, as the part of its first register. The other registers' parts do nothing.
class ShiftRegisterPart final : public Part, public PinWatcher {
 public:
  ShiftRegisterPart(const ShiftRegisterSpec& head, std::vector<int> chain, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  void power(bool on, SimTime) override;

 private:
  void forget();
  void show(SimTime);

  struct State {
    std::uint64_t shifted = 0;    // bit 8 r + q is Qq of register chain_[r]
    std::uint64_t latched = 0;    // the bits of `shifted` that the outputs have
    std::uint64_t power_ons = 0;  // number of noise samples taken
    bool clock = false;
    bool latch = false;
    bool on = true;
  };

  const ShiftRegisterSpec& spec_;
  PartContext& context_;
  const std::vector<int> chain_;  // indices of its registers, from the board outwards
  State state_;
};

}  // namespace robosim::robot
