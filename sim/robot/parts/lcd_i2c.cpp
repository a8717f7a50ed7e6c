#include "sim/robot/parts/lcd_i2c.h"

namespace robosim::robot {
namespace {

constexpr int kUsualLcdAddress = 0x27;
constexpr std::uint8_t kRs = 0x01, kReads = 0x02, kEnable = 0x04, kDataPins = 0xF0;

}  // namespace

std::shared_ptr<const PartSpec> read_lcd_i2c(PartReader& reader) {
  auto spec = std::make_shared<LcdI2cSpec>();
  spec->address = read_two_wire(reader, kUsualLcdAddress);
  spec->columns = static_cast<int>(reader.table().integer("columns", 16, 8, 40));
  spec->rows = static_cast<int>(reader.table().integer("rows", 2, 1, 4));
  return reader.finish(spec);
}

std::unique_ptr<Part> LcdI2cSpec::make(PartContext& context) const {
  return std::make_unique<LcdI2cPart>(*this, context);
}

LcdI2cPart::LcdI2cPart(const LcdI2cSpec& spec, PartContext& context) : spec_(spec), context_(context) {
  context.snapshots.add(state_);
}

void LcdI2cPart::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.text_outputs.push_back(this);
}

bool LcdI2cPart::write(std::uint8_t byte, SimTime t) {
  const bool fell = state_.pins & kEnable && !(byte & kEnable);
  state_.pins = byte;
  if (fell && !(byte & kReads)) state_.controller.write(byte & kRs, byte & kDataPins, t);
  return true;
}

std::string LcdI2cPart::poll_text(SimTime t) {
  const SimTime changed = state_.controller.changed_at();
  if (!state_.text.is_due(changed, t)) return {};
  return state_.text.poll_text(changed, state_.controller.text(spec_.columns, spec_.rows));
}

void LcdI2cPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.controller.text(spec_.columns, spec_.rows).empty() ? 0.0 : 1.0});
}

}  // namespace robosim::robot
