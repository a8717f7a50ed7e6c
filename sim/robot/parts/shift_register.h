// type = "shift-register": a 74HC595 (TI SN74HC595, SCLS041), which turns three of the board's pins into
// eight outputs.
//
//   rising edge of clock   every bit moves by one, from Q0 towards Q7; the level of data enters at Q0
//   rising edge of latch   the outputs Q0 .. Q7 are set to the shifted bits
//   enable (OE) high       the outputs are switched off: they are not driven. An unwired OE is tied low
//
// A register with `after` follows another register in a chain. Its input is the output of the previous
// register, and clock, latch and enable are shared. Of several bytes, the byte shifted first ends up in the
// last register. Other parts refer to the outputs as pins: "REG1.Q4".
//
// At power-on the contents are undefined (`typical`: random; `ideal`: zeros) until the sketch has shifted and
// latched. The register shares the board's supply. While the supply is off, the outputs are not driven. Not
// modelled: propagation delay (about 20 ns) and the reset input.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

constexpr std::size_t kMostChained = 8;  ///< maximum number of registers in one chain

std::shared_ptr<const PartSpec> read_shift_register(PartReader&);

/// Checks that each `after` names an existing register, and that no two registers follow the same one. Each
/// chain must begin at pins, and have at most kMostChained registers. Throws InputError.
void check_chains(const Description&);

class ShiftRegisterSpec final : public PartSpec {
 public:
  int index = 0;  ///< number among the robot's registers; the outputs are output_pin(index, 0 .. 7)
  Pin data = kNoPin;
  Pin clock = kNoPin;
  Pin latch = kNoPin;
  Pin enable = kNoPin;  ///< kNoPin = tied low
  std::string after;    ///< the previous register; empty = first of the chain, connected to pins
  Place after_place;

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// Simulates a whole chain, as the part of its first register. The parts of the other registers do nothing.
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
    std::uint64_t latched = 0;    // the bits at the outputs, in the order of `shifted`
    std::uint64_t power_ons = 0;  // number of noise samples taken
    bool clock = false;
    bool latch = false;
    bool on = true;
  };

  const ShiftRegisterSpec& spec_;
  PartContext& context_;
  const std::vector<int> chain_;  // indices of the chain's registers, from the board outwards
  State state_;
};

}  // namespace robosim::robot
