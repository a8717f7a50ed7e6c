// type = "ir-switch": an infrared obstacle module (FC-51 and similar) or Sharp's GP2Y0D. Its pin reports
// whether an object is nearer than `range`. The sensor measures along a ray, once per millisecond. A detected
// object stays detected up to a range that is 10 % larger (the comparator's hysteresis; an estimate). The
// object's reflectance has no influence.
#pragma once

#include "sim/robot/parts/mount.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ir_switch(PartReader&);

class IrSwitchSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  MountSpec mount;
  Parameter range;  ///< m
  bool active_high = false;

  std::unique_ptr<Part> make(PartContext&) const override;
  const MountSpec* mounted() const override { return &mount; }
};

class IrSwitchPart final : public Part, public PinSource, public Breakable {
 public:
  IrSwitchPart(const IrSwitchSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void resolve_mounts(const PartRegistry& registry) override { mount_.resolve_mounts(registry); }
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  bool level(SimTime) override { return sees() == spec_.active_high; }
  SimTime same_until(SimTime) override { return context_.view.tick_start + kTick; }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  bool sees() const { return state_.stuck == Stuck::no ? state_.near : state_.stuck == Stuck::seeing; }

  enum class Stuck { no, seeing, blind };
  struct State {
    bool near = false;
    bool told = false;  // sees() in the last tick
    Stuck stuck = Stuck::no;
  };

  const IrSwitchSpec& spec_;
  PartContext& context_;
  Mount mount_;
  const double range_;
  State state_;
};

}  // namespace robosim::robot
