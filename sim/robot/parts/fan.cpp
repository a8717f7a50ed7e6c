#include "sim/robot/parts/fan.h"

#include "sim/base/units.h"
#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

constexpr double kTickSeconds = 1e-9 * static_cast<double>(kTick);
constexpr Parameter kSpinUp{0.3, 0.0};  // s, an estimate for a ducted fan of 30 mm

double share_of_tick(double spin_up) { return kTickSeconds / (spin_up + kTickSeconds); }

}  // namespace

std::shared_ptr<const PartSpec> read_fan(PartReader& reader) {
  auto spec = std::make_shared<FanSpec>();
  spec->pin = reader.pin("pin", PinUse::driven);
  reader.table().require("downforce");
  spec->downforce = reader.figure("downforce", Dimension::mass, {}, 0.0, 5.0);
  spec->spin_up = reader.figure("spin_up", Dimension::time, kSpinUp, 0.0, 10.0);
  return reader.finish(spec);
}

std::unique_ptr<Part> FanSpec::make(PartContext& context) const {
  return std::make_unique<FanPart>(*this, context);
}

FanPart::FanPart(const FanSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      most_(kGravity * context.sampler.draw(spec.downforce, spec.name, "downforce")),
      share_(share_of_tick(context.sampler.draw(spec.spin_up, spec.name, "spin_up"))) {
  context.snapshots.add(state_);
}

void FanPart::register_with(PartRegistry& registry) {
  registry.ticking.push_back(this);
  registry.supplied.push_back(this);
  registry.fans.push_back(this);
}

void FanPart::begin_tick(SimTime) {
  const PinDrive& drive = context_.netlist.drive(spec_.pin);
  const bool runs = state_.powered && drive.mode == PinMode::output;
  state_.speed += ((runs ? high_share(drive) : 0.0) - state_.speed) * share_;
  const double newtons = most_ * state_.speed * state_.speed;
  body_->press(body_->params().downforce_n + (newtons - state_.newtons));
  state_.newtons = newtons;
}

void FanPart::read(std::vector<Reading>& readings) const { readings.push_back({spec_.name, state_.speed}); }

}  // namespace robosim::robot
