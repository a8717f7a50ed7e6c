#include "sim/robot/parts/buzzer.h"

#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

constexpr SimTime kDiesAway = 50 * kMillisecond;
constexpr double kPwmPitch = 490.0;  // Hz, PWM frequency of most pins of an Uno

}  // namespace

std::shared_ptr<const PartSpec> read_buzzer(PartReader& reader) {
  auto spec = std::make_shared<BuzzerSpec>();
  spec->pin = reader.pin("pin", PinUse::driven);
  spec->passive = reader.table().boolean("passive", true);
  return reader.finish(spec);
}

std::unique_ptr<Part> BuzzerSpec::make(PartContext& context) const {
  return std::make_unique<BuzzerPart>(*this, context);
}

BuzzerPart::BuzzerPart(const BuzzerSpec& spec, PartContext& context) : spec_(spec), context_(context) {
  context.snapshots.add(state_);
}

void BuzzerPart::register_with(PartRegistry&) {
  if (spec_.passive) context_.netlist.watch(spec_.pin, *this);
}

void BuzzerPart::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const bool high = drive.mode == PinMode::output && !drive.pwm && drive.level;
  if (high && !state_.high) {
    state_.rose_before = state_.rose;
    state_.rose = t;
  }
  state_.high = high;
}

double BuzzerPart::pitch(SimTime t) const {
  const PinDrive& drive = context_.netlist.drive(spec_.pin);
  if (drive.mode != PinMode::output) return 0.0;
  if (drive.tone_hz) return drive.tone_hz;
  if (drive.pwm) return drive.duty > 0.0 && drive.duty < 1.0 ? kPwmPitch : 0.0;
  const SimTime period = state_.rose - state_.rose_before;
  return t - state_.rose < kDiesAway && period > 0 && period < kDiesAway ? 1e9 / static_cast<double>(period)
                                                                         : 0.0;
}

void BuzzerPart::read(std::vector<Reading>& readings) const {
  const PinDrive& drive = context_.netlist.drive(spec_.pin);
  const double value = spec_.passive                   ? pitch(context_.view.tick_start)
                       : drive.mode == PinMode::output ? high_share(drive)
                                                       : 0.0;
  readings.push_back({spec_.name, value});
}

}  // namespace robosim::robot
