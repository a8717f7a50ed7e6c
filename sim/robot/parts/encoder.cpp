#include "sim/robot/parts/encoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robosim::robot {
namespace {

constexpr FaultKind kEncoderFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "its levels never change"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_encoder(PartReader& reader) {
  auto spec = std::make_shared<EncoderSpec>();
  spec->wheel = reader.wheel();
  spec->periods = as_quantity(reader.table().require("periods"), "periods", Dimension::ratio, 1.0, 20000.0);
  spec->reversed = reader.table().boolean("reversed", false);
  std::size_t wiring = 0;
  const std::vector<Pin> pins = reader.pin_table({{"a", "b"}, {"a"}}, wiring);
  spec->a = pins[0];
  if (wiring == 0) spec->b = pins[1];
  return reader.finish(spec);
}

std::unique_ptr<Part> EncoderSpec::make(PartContext& context) const {
  return std::make_unique<EncoderPart>(*this, context);
}

EncoderPart::EncoderPart(const EncoderSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      a_(*this, 0),
      b_(*this, 3),
      quarters_per_rad_((spec.reversed ? -4.0 : 4.0) * spec.periods / (2.0 * std::numbers::pi)) {
  context.snapshots.add(state_);
}

void EncoderPart::register_with(PartRegistry& registry) {
  context_.board.connect(spec_.a, a_);
  if (spec_.b != kNoPin) context_.board.connect(spec_.b, b_);
  registry.edge_makers.push_back(this);
  registry.breakable.push_back(this);
}

std::int64_t EncoderPart::quarter(SimTime t) const {
  const SimTime start = context_.view.tick_start;
  if (state_.looked_at != start && !state_.dead) {
    const world::Body& body = *context_.view.body;
    state_.looked_at = start;
    state_.at = 1.5 + quarters_per_rad_ * body.wheel_angle(spec_.wheel);
    state_.per_ns = quarters_per_rad_ * body.wheel_rate(spec_.wheel) * 1e-9;
  }
  return static_cast<std::int64_t>(std::floor(state_.at + state_.per_ns * static_cast<double>(t - start)));
}

void EncoderPart::begin_tick(SimTime t) {
  const bool wanted =
      context_.board.wants_edges(spec_.a) || (spec_.b != kNoPin && context_.board.wants_edges(spec_.b));
  if (wanted) {
    if (!state_.followed) state_.last = quarter(t);
    const std::int64_t end = quarter(t + kTick - 1);
    if (end != state_.last) announce(state_.last, end);
    state_.last = end;
  }
  state_.followed = wanted;
}

void EncoderPart::announce(std::int64_t from, std::int64_t to) {
  const bool a = context_.board.wants_edges(spec_.a);
  const bool b = spec_.b != kNoPin && context_.board.wants_edges(spec_.b);
  const bool forward = to > from;
  for (std::int64_t q = from; q != to;) {
    const std::int64_t next = forward ? q + 1 : q - 1;
    const SimTime at = time_of(next, forward);
    if (a && a_.level_of(next) != a_.level_of(q))
      context_.board.schedule_edge(spec_.a, a_.level_of(next), at);
    if (b && b_.level_of(next) != b_.level_of(q))
      context_.board.schedule_edge(spec_.b, b_.level_of(next), at);
    q = next;
  }
}

SimTime EncoderPart::time_of(std::int64_t edge, bool forward) const {
  const SimTime start = context_.view.tick_start;
  if (state_.per_ns == 0.0) return start;
  const auto border = static_cast<double>(forward ? edge : edge + 1);
  const double ns = std::clamp((border - state_.at) / state_.per_ns, 0.0, static_cast<double>(kTick - 1));
  SimTime t = start + static_cast<SimTime>(ns);
  const auto beyond = [&](SimTime time) { return forward ? quarter(time) >= edge : quarter(time) <= edge; };
  while (t > start && beyond(t - 1)) --t;
  while (t < start + kTick - 1 && !beyond(t)) ++t;
  return t;
}

void EncoderPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, a_.level_of(quarter(context_.view.tick_start)) ? 1.0 : 0.0});
}

std::span<const FaultKind> EncoderPart::fault_kinds() const { return kEncoderFaults; }

void EncoderPart::fail(const Fault& fault) {
  const std::int64_t now = quarter(context_.view.tick_start);
  state_.dead = fault.failure == Failure::dead;
  if (state_.dead) state_.at = static_cast<double>(now) + 0.5;
  if (state_.dead) state_.per_ns = 0.0;
  state_.looked_at = -1;
  state_.followed = false;
}

}  // namespace robosim::robot
