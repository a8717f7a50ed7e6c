// type = "led": an LED, whose light affects nothing else.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_led(PartReader&);

class IndicatorSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  bool active_high = true;

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// An LED, whose reading is its brightness.
class IndicatorPart final : public Part {
 public:
  IndicatorPart(const IndicatorSpec& spec, PartContext& context) : spec_(spec), context_(context) {}

  void register_with(PartRegistry&) override {}
  void read(std::vector<Reading>&) const override;

 private:
  const IndicatorSpec& spec_;
  PartContext& context_;
};

}  // namespace robosim::robot
