// type = "voltage": an analog voltage on a pin: a battery divider, a potentiometer, a jumper.
//
// The voltage is `volts`, or `share` times the battery's present voltage, plus normal noise with the standard
// deviation `noise`. The sum is limited to the range from 0 to the board's supply.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_voltage(PartReader&);

class VoltageSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Parameter volts;  ///< V; not used if share is not 0
  Parameter share;  ///< fraction of the battery's voltage
  Parameter noise;  ///< V, standard deviation
  Parameter source_ohms;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class VoltagePart final : public Part, public PinSource {
 public:
  VoltagePart(const VoltageSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  Source output(SimTime, double supply) override;
  bool level(SimTime t) override { return output(t, supply_).volts > 0.5 * supply_; }

 private:
  struct State {
    std::uint64_t samples = 0;
  };

  const VoltageSpec& spec_;
  PartContext& context_;
  const NoiseStream stream_;
  const double supply_, volts_, battery_volts_, noise_, source_ohms_;
  State state_;
};

}  // namespace robosim::robot
