// type = "button": a push button between a pin and ground (active = "low") or the supply (active = "high").
//
// A pressed button drives the pin. While the button is released, its own resistor (resistor = true) or the
// pin's pull-up drives the pin. If neither exists, the pin floats. A floating pin reads low in the profile
// `ideal`, and a new random level every millisecond in `typical`.
//
// In `typical`, the contact bounces: after each press and release, it opens and closes up to 4 more times
// within `bounce`. The number and times of the bounces are random. The default of 1.6 ms is the mean of 18
// switches in J. Ganssle, "A Guide to Debouncing".
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_button(PartReader&);

class ButtonSpec : public PartSpec {
 public:
  Pin pin = kNoPin;
  bool active_high = false;
  bool resistor = false;
  Parameter bounce;  ///< s

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// Reads the keys of a button's table into a spec, which may belong to a part that contains a button.
std::shared_ptr<const PartSpec> read_button_keys(PartReader&, std::shared_ptr<ButtonSpec>);

class ButtonPart : public Part, public PinSource, public Pressable, public Breakable {
 public:
  ButtonPart(const ButtonSpec&, PartContext&);

  void hold(bool down, SimTime t) override;
  ButtonPart* bounces() override { return this; }
  bool settled() const { return state_.announced == state_.flips.size(); }

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;
  bool level(SimTime t) override;
  SimTime same_until(SimTime t) override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  enum class Stuck { no, pressed, released };

  /// Returns whether the contact is closed at `t`.
  bool closed(SimTime t) const;
  /// Returns whether something drives the pin at `t`: the contact, or a fault.
  bool pulls(SimTime t) const;
  /// Returns whether nothing drives the pin, not even a resistor.
  bool floats(SimTime t) const;

  struct State {
    std::uint64_t moves = 0;
    bool down = false;
    bool was_closed = false;     // contact state before the first of `flips`
    std::vector<SimTime> flips;  // times at which the contact changes after the last hold()
    std::size_t announced = 0;   // number of flips that have been scheduled
    Stuck stuck = Stuck::no;
  };

  const ButtonSpec& spec_;
  PartContext& context_;
  const NoiseStream stream_;
  const double bounce_;
  State state_;
};

}  // namespace robosim::robot
