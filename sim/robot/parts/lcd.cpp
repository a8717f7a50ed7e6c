#include "sim/robot/parts/lcd.h"

#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

constexpr SimTime kEnableWidth = 230;  // ns, PW_EH at 4.5 to 5.5 V

}  // namespace

std::shared_ptr<const PartSpec> read_lcd(PartReader& reader) {
  auto spec = std::make_shared<LcdSpec>();
  std::size_t wiring = 0;
  const std::vector<Pin> pins =
      reader.pin_table({{"rs", "en", "d4", "d5", "d6", "d7"},
                        {"rs", "en", "rw", "d4", "d5", "d6", "d7"},
                        {"rs", "en", "d0", "d1", "d2", "d3", "d4", "d5", "d6", "d7"},
                        {"rs", "en", "rw", "d0", "d1", "d2", "d3", "d4", "d5", "d6", "d7"}},
                       wiring, PinUse::driven);
  const bool has_rw = wiring % 2 == 1;
  spec->rs = pins[0];
  spec->enable = pins[1];
  if (has_rw) spec->rw = pins[2];
  spec->data.assign(pins.begin() + (has_rw ? 3 : 2), pins.end());
  spec->columns = static_cast<int>(reader.table().integer("columns", 16, 8, 40));
  spec->rows = static_cast<int>(reader.table().integer("rows", 2, 1, 4));
  return reader.finish(spec);
}

std::unique_ptr<Part> LcdSpec::make(PartContext& context) const {
  return std::make_unique<LcdPart>(*this, context);
}

LcdPart::LcdPart(const LcdSpec& spec, PartContext& context) : spec_(spec), context_(context) {
  context.snapshots.add(state_);
}

void LcdPart::register_with(PartRegistry& registry) {
  context_.netlist.watch(spec_.enable, *this);
  registry.text_outputs.push_back(this);
}

bool LcdPart::high(Pin pin) const { return high_share(context_.netlist.drive(pin)) > 0.5; }

void LcdPart::pin_changed(Pin, const PinDrive&, SimTime t) {
  const bool enabled = high(spec_.enable);
  const bool fell = state_.enabled && !enabled;
  if (enabled && !state_.enabled) state_.since = t;
  state_.enabled = enabled;
  if (!fell || t - state_.since < kEnableWidth || (spec_.rw != kNoPin && high(spec_.rw))) return;
  unsigned lines = 0;
  for (std::size_t i = 0; i < spec_.data.size(); ++i)
    if (high(spec_.data[i])) lines |= 1u << (i + 8 - spec_.data.size());
  state_.controller.write(high(spec_.rs), static_cast<std::uint8_t>(lines), t);
}

std::string LcdPart::poll_text(SimTime t) {
  const SimTime changed = state_.controller.changed_at();
  if (!state_.text.is_due(changed, t)) return {};
  return state_.text.poll_text(changed, state_.controller.text(spec_.columns, spec_.rows));
}

void LcdPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.controller.text(spec_.columns, spec_.rows).empty() ? 0.0 : 1.0});
}

}  // namespace robosim::robot
