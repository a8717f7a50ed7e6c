#include "sim/robot/parts/ws2812.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr SimTime kIsOne = 550;  // ns
constexpr SimTime kReset = 50 * kMicrosecond;
constexpr SimTime kStays = 50 * kMillisecond;
constexpr int kColourBits = 24;

}  // namespace

std::shared_ptr<const PartSpec> read_ws2812(PartReader& reader) {
  auto spec = std::make_shared<Ws2812Spec>();
  spec->pin = reader.pin("pin", PinUse::digital);
  spec->leds = static_cast<int>(reader.table().integer("leds", 1, 1, 300));
  return reader.finish(spec);
}

std::unique_ptr<Part> Ws2812Spec::make(PartContext& context) const {
  return std::make_unique<Ws2812Part>(*this, context);
}

Ws2812Part::Ws2812Part(const Ws2812Spec& spec, PartContext& context) : spec_(spec), context_(context) {
  state_.shown.resize(static_cast<std::size_t>(spec.leds));
  context.snapshots.add(state_);
}

void Ws2812Part::register_with(PartRegistry& registry) {
  context_.board.watch(spec_.pin, *this);
  registry.text_outputs.push_back(this);
}

void Ws2812Part::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const bool high = drive.mode == PinMode::output && !drive.pwm && drive.level;
  if (high == state_.high) return;
  const SimTime lasted = t - state_.since;
  state_.high = high;
  state_.since = t;
  if (high) {
    if (lasted >= kReset) show();
    return;
  }
  if (state_.coming.size() > state_.shown.size()) return;
  if (state_.bits == 0 || state_.bits == kColourBits) {
    state_.coming.push_back(0);
    state_.bits = 0;
  }
  state_.coming.back() = state_.coming.back() << 1 | (lasted >= kIsOne ? 1u : 0u);
  ++state_.bits;
}

void Ws2812Part::show() {
  if (state_.bits != kColourBits && !state_.coming.empty()) state_.coming.pop_back();
  const std::size_t count = std::min(state_.coming.size(), state_.shown.size());
  if (!std::equal(state_.coming.begin(), state_.coming.begin() + static_cast<std::ptrdiff_t>(count),
                  state_.shown.begin()))
    state_.changed_at = state_.since;
  std::copy_n(state_.coming.begin(), count, state_.shown.begin());
  state_.coming.clear();
  state_.bits = 0;
}

std::string Ws2812Part::poll_text(SimTime t) {
  if (!state_.high && !state_.coming.empty() && t - state_.since >= kReset) show();
  if (state_.changed_at == kNever || t - state_.changed_at < kStays) return {};
  state_.changed_at = kNever;
  std::string text;
  for (const std::uint32_t grb : state_.shown)
    text += fmt::format("{}{:02X}{:02X}{:02X}", text.empty() ? "" : " ", grb >> 8 & 0xFF, grb >> 16 & 0xFF,
                        grb & 0xFF);
  return text;
}

void Ws2812Part::read(std::vector<Reading>& readings) const {
  const auto dark = std::count(state_.shown.begin(), state_.shown.end(), 0u);
  readings.push_back({spec_.name, static_cast<double>(state_.shown.size()) - static_cast<double>(dark)});
}

}  // namespace robosim::robot
