// type = "stepper": a geared stepper motor with four coils, a 28BYJ-48 on a ULN2003 board. The motor turns
// a pointer, a turret or a gate, and does not drive a wheel.
//
//   coils     a high pin switches its coil on; the coils together set the field's direction, in eighths of
//             a period: IN1 0, IN1+IN2 1, IN2 2, IN2+IN3 3, IN3 4, IN3+IN4 5, IN4 6, IN4+IN1 7. Opposite
//             coils cancel; without a field, the gear holds the rotor
//   rotor     follows the field by the shorter way, at `speed` at most; a field that leads by half a period
//             or more pulls it back, and steps are lost
//   angle     360 degrees / `steps` for each eighth of a period (a half step); 0 at power-on
//
// Sources: 28BYJ-48 data sheet (Kiatronics): 5.625 degrees / 64, "Idle Out-traction Frequency" above 1000 Hz.
// The gear ratio is 63.684 : 1 (25792 / 405), so a turn has 4075.77 half steps, not 4096. Not modelled: load,
// inertia, resonance, PWM of coils.
#pragma once

#include <array>
#include <vector>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_stepper(PartReader&);

class StepperSpec final : public PartSpec {
 public:
  std::vector<Pin> coils;  ///< IN1 to IN4
  Parameter steps;         ///< half steps per turn of the shaft
  Parameter speed;         ///< rad/s of the shaft
  bool reversed = false;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "deg"}}; }
};

class StepperPart final : public Part, public PinWatcher, public Breakable {
 public:
  StepperPart(const StepperSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  /// Appends the angle in degrees from the start; positive for the order IN1, IN2, IN3, IN4.
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  static constexpr int kNoField = -1;
  int field() const;
  /// Returns the rotor's position in half steps.
  double rotor(SimTime t) const;

  struct State {
    double from = 0.0;  // half steps, the rotor's position at `since`
    SimTime since = 0;
    int field = kNoField;  // half steps, the field's direction, 0 to 7
    bool stuck = false;
  };

  const StepperSpec& spec_;
  PartContext& context_;
  const double steps_;  // per turn
  const double rate_;   // maximum rate, half steps per ns
  State state_;
};

}  // namespace robosim::robot
