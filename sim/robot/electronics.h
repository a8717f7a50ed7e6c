// Models the table [electronics] of a robot file: the path from the battery through the board's supply to
// its ADC. Without this table, the supply is constant and the ADC is exact.
//
//   supply = min(nominal, battery - drop of the board's regulator)    if fed_by_battery
//   code   = volts / supply * steps + adc_noise g                     g: standard normal, one per conversion
//
// The supply is also the ADC's reference. A sensor that outputs volts (a battery's divider, an infra-red
// distance sensor) therefore reads higher when the supply drops. A sensor that outputs a share of the supply
// reads the same value. Examples are a reflectance sensor's divider, and a current sensor whose zero is at
// half the supply.
//
// The brightness of emitters drops with the current through their resistor:
//   (supply - 1.2 V) / (nominal - 1.2 V)    1.2 V: forward voltage of infra-red LEDs, by their data sheets
//
// Other references of the ADC (INTERNAL), the bandgap and an STM32's VREFINT do not drop. Not modelled: a
// reset of the chip by low supply.
#pragma once

#include <memory>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/config.h"
#include "sim/base/noise.h"
#include "sim/base/parameter.h"
#include "sim/base/snapshot_registry.h"

namespace robosim::robot {

struct Electronics {
  Parameter adc_noise;          ///< standard deviation of a conversion, in steps of the ADC
  bool fed_by_battery = false;  ///< the board's supply drops with the motors' battery; else it is constant
};

/// Reads [electronics]. Throws InputError.
Electronics read_electronics(const ConfigValue& table);

/// The current state of a board's supply.
struct Supply {
  double volts = 0.0;
  double led = 1.0;  ///< brightness of an infra-red LED with a resistor; 1 at nominal voltage
};
Supply supply_at(double battery_volts, const BoardSpec& board);

/// Adds the noise of a robot's ADC to the sources at its analog pins.
class AnalogInputs {
 public:
  /// `noise_volts` is the standard deviation of a conversion at nominal supply. `snapshots` must outlive this
  /// object.
  AnalogInputs(RobotPort& board, double noise_volts, const NoiseStream& noise, SnapshotRegistry& snapshots);
  ~AnalogInputs();

  /// Connects a source to a pin, like RobotPort::connect().
  void connect(Pin pin, PinSource& source);

 private:
  class Input;

  RobotPort& board_;
  const double noise_volts_;
  const NoiseStream noise_;
  SnapshotRegistry& snapshots_;
  std::vector<std::unique_ptr<Input>> inputs_;
};

}  // namespace robosim::robot
