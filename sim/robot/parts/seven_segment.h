// type = "seven-segment": one digit with a light for each segment:
//
//    aaa        pins a to g, and dp (the point) if it is wired
//   f   b       common = "anode": a low pin lights its segment; "cathode": a high pin
//    ggg
//   e   c
//    ddd  dp
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_seven_segment(PartReader&);

class SevenSegmentSpec final : public PartSpec {
 public:
  std::vector<Pin> segments;  ///< a to g, then dp if it is wired
  bool low_lights = true;     ///< common anode

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// A display, whose reading is the visible digit 0 .. 9; -1 if all segments are dark, -2 for any other
/// pattern. The point is ignored.
class SevenSegmentPart final : public Part {
 public:
  SevenSegmentPart(const SevenSegmentSpec& spec, PartContext& context) : spec_(spec), context_(context) {}

  void register_with(PartRegistry&) override {}
  void read(std::vector<Reading>&) const override;

 private:
  const SevenSegmentSpec& spec_;
  PartContext& context_;
};

}  // namespace robosim::robot
