#include "sim/robot/parts/seven_segment.h"

#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

constexpr unsigned kSegments = 7;

struct Shape {
  unsigned lit;  // bit 0 = a … bit 6 = g
  double figure;
};

// Accepts 6, 7 and 9 with and without tails.
constexpr Shape kShapes[] = {{0x3F, 0}, {0x06, 1}, {0x5B, 2}, {0x4F, 3}, {0x66, 4}, {0x6D, 5}, {0x7D, 6},
                             {0x7C, 6}, {0x07, 7}, {0x27, 7}, {0x7F, 8}, {0x6F, 9}, {0x67, 9}, {0x00, -1}};
constexpr double kNoFigure = -2;

}  // namespace

std::shared_ptr<const PartSpec> read_seven_segment(PartReader& reader) {
  auto spec = std::make_shared<SevenSegmentSpec>();
  spec->low_lights = reader.table().choice("common", "anode", {"anode", "cathode"}) == "anode";
  std::size_t wiring = 0;
  spec->segments =
      reader.pin_table({{"a", "b", "c", "d", "e", "f", "g"}, {"a", "b", "c", "d", "e", "f", "g", "dp"}},
                       wiring, PinUse::driven);
  return reader.finish(spec);
}

std::unique_ptr<Part> SevenSegmentSpec::make(PartContext& context) const {
  return std::make_unique<SevenSegmentPart>(*this, context);
}

void SevenSegmentPart::read(std::vector<Reading>& readings) const {
  unsigned lit = 0;
  for (unsigned i = 0; i < kSegments; ++i) {
    const PinDrive& drive = context_.netlist.drive(spec_.segments[i]);
    if (drive.mode == PinMode::output && (high_share(drive) < 0.5) == spec_.low_lights) lit |= 1u << i;
  }
  double value = kNoFigure;
  for (const Shape& shape : kShapes)
    if (shape.lit == lit) value = shape.figure;
  readings.push_back({spec_.name, value});
}

}  // namespace robosim::robot
