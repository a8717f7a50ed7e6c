#include "sim/robot/parts/indicator.h"

#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_led(PartReader& reader) {
  auto spec = std::make_shared<IndicatorSpec>();
  spec->pin = reader.pin("pin", PinUse::driven);
  spec->active_high = reader.high("active", true);
  return reader.finish(spec);
}

std::unique_ptr<Part> IndicatorSpec::make(PartContext& context) const {
  return std::make_unique<IndicatorPart>(*this, context);
}

void IndicatorPart::read(std::vector<Reading>& readings) const {
  const PinDrive& drive = context_.netlist.drive(spec_.pin);
  double value = 0.0;
  if (drive.mode == PinMode::output) value = spec_.active_high ? high_share(drive) : 1.0 - high_share(drive);
  readings.push_back({spec_.name, value});
}

}  // namespace robosim::robot
