#include "sim/robot/parts/button.h"

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr int kMostBounces = 4;

constexpr FaultKind kButtonFaults[] = {
    {Failure::ok, "works again"},
    {Failure::pressed, "its contact is always closed"},
    {Failure::released, "its contact never closes"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_button(PartReader& reader) {
  return read_button_keys(reader, std::make_shared<ButtonSpec>());
}

std::shared_ptr<const PartSpec> read_button_keys(PartReader& reader, std::shared_ptr<ButtonSpec> spec) {
  spec->pin = reader.pin("pin", PinUse::digital);
  spec->active_high = reader.high("active", false);
  spec->resistor = reader.table().boolean("resistor", spec->active_high);
  spec->bounce = reader.figure("bounce", Dimension::time, {1.6e-3, 0.0}, 0.0, 0.05);
  const std::shared_ptr<const PartSpec> finished = reader.finish(spec);
  for (Wire& wire : spec->wires) wire.may_float = !spec->resistor;
  return finished;
}

std::unique_ptr<Part> ButtonSpec::make(PartContext& context) const {
  return std::make_unique<ButtonPart>(*this, context);
}

ButtonPart::ButtonPart(const ButtonSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      stream_(context.sampler.noise(spec.name, "bounce")),
      bounce_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.bounce, spec.name, "bounce time")) {
  context.snapshots.add(state_);
}

void ButtonPart::register_with(PartRegistry& registry) {
  context_.board.connect(spec_.pin, *this);
  registry.pressable.push_back(this);
  registry.breakable.push_back(this);
}

void ButtonPart::hold(bool down, SimTime t) {
  if (down == state_.down) return;
  state_.was_closed = closed(t);
  state_.down = down;
  state_.flips.clear();
  state_.announced = 0;
  if (state_.was_closed != down) state_.flips.push_back(t);
  const std::uint64_t draws = state_.moves++ * (2 * kMostBounces + 1);
  const auto bounces = bounce_ > 0.0 ? static_cast<int>(stream_.uniform(draws) * (kMostBounces + 1)) : 0;
  for (int i = 0; i < 2 * bounces; ++i)
    state_.flips.push_back(
        t + static_cast<SimTime>(stream_.uniform(draws + 1 + static_cast<std::uint64_t>(i)) * bounce_ * 1e9));
  std::sort(state_.flips.begin(), state_.flips.end());
}

bool ButtonPart::closed(SimTime t) const {
  const auto passed = std::upper_bound(state_.flips.begin(), state_.flips.end(), t) - state_.flips.begin();
  return state_.was_closed != ((passed & 1) != 0);
}

bool ButtonPart::pulls(SimTime t) const {
  return state_.stuck == Stuck::no ? closed(t) : state_.stuck == Stuck::pressed;
}

bool ButtonPart::floats(SimTime t) const {
  return !pulls(t) && !spec_.resistor && context_.board.drive(spec_.pin).mode != PinMode::input_pullup;
}

SimTime ButtonPart::same_until(SimTime t) {
  if (floats(t) && !context_.sampler.ideal()) return t;
  const auto next = std::upper_bound(state_.flips.begin(), state_.flips.end(), t);
  return next == state_.flips.end() ? kNever : *next;
}

bool ButtonPart::level(SimTime t) {
  if (pulls(t)) return spec_.active_high;
  if (!floats(t)) return spec_.resistor ? !spec_.active_high : true;
  if (context_.sampler.ideal()) return false;
  return context_.sampler.noise(spec_.name, "floating").bits(static_cast<std::uint64_t>(t / kMillisecond)) &
         1;
}

void ButtonPart::begin_tick(SimTime t) {
  const bool wanted = context_.board.wants_edges(spec_.pin);
  for (; state_.announced < state_.flips.size() && state_.flips[state_.announced] < t + kTick;
       ++state_.announced) {
    const SimTime at = std::max(state_.flips[state_.announced], t);
    if (wanted) context_.board.schedule_edge(spec_.pin, level(at), at);
  }
}

void ButtonPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.down ? 1.0 : 0.0});
}

std::span<const FaultKind> ButtonPart::fault_kinds() const { return kButtonFaults; }

void ButtonPart::fail(const Fault& fault) {
  state_.stuck = fault.failure == Failure::pressed    ? Stuck::pressed
                 : fault.failure == Failure::released ? Stuck::released
                                                      : Stuck::no;
}

}  // namespace robosim::robot
