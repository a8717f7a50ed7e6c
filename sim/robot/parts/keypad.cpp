#include "sim/robot/parts/keypad.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr std::size_t kMostLeads = 8;  // maximum number of rows, and of columns

std::vector<std::string> usual_keys(std::size_t rows, std::size_t columns) {
  const std::vector<std::string> keys{"123A", "456B", "789C", "*0#D"};
  if (rows > keys.size() || columns > keys[0].size()) return {};
  std::vector<std::string> cut;
  for (std::size_t row = 0; row < rows; ++row) cut.push_back(keys[row].substr(0, columns));
  return cut;
}

}  // namespace

std::shared_ptr<const PartSpec> read_keypad(PartReader& reader) {
  auto spec = std::make_shared<KeypadSpec>();
  spec->rows = reader.pin_list(PinUse::digital, kMostLeads, "rows", "row");
  spec->columns = reader.pin_list(PinUse::digital, kMostLeads, "columns", "column");
  const ConfigValue* keys = reader.table().find("keys");
  if (!keys) {
    spec->keys = usual_keys(spec->rows.size(), spec->columns.size());
  } else if (keys->kind == ConfigValue::Kind::array) {
    for (const ConfigValue& row : keys->items) spec->keys.push_back(as_string(row, "keys"));
  }
  const bool fits = spec->keys.size() == spec->rows.size() &&
                    std::all_of(spec->keys.begin(), spec->keys.end(),
                                [&](const std::string& row) { return row.size() == spec->columns.size(); });
  if (!fits)
    throw InputError(
        (keys ? *keys : reader.table().table()).place,
        fmt::format(
            "keys: expected a string for each row, with a character for each column, such as [\"123\", "
            "\"456\"]; for these pins, {} strings of {} characters",
            spec->rows.size(), spec->columns.size()));
  return reader.finish(spec);
}

std::unique_ptr<Part> KeypadSpec::make(PartContext& context) const {
  return std::make_unique<KeypadPart>(*this, context);
}

KeypadPart::KeypadPart(const KeypadSpec& spec, PartContext& context) : spec_(spec), context_(context) {
  pins_ = spec.rows;
  pins_.insert(pins_.end(), spec.columns.begin(), spec.columns.end());
  for (std::size_t lead = 0; lead < pins_.size(); ++lead)
    leads_.push_back(std::make_unique<Lead>(*this, lead));
  for (std::size_t row = 0; row < spec.rows.size(); ++row)
    for (std::size_t column = 0; column < spec.columns.size(); ++column)
      keys_.push_back(std::make_unique<Key>(*this, fmt::format("{}.{}", spec.name, spec.keys[row][column]),
                                            row * spec.columns.size() + column));
  context.snapshots.add(state_);
}

void KeypadPart::register_with(PartRegistry& registry) {
  for (std::size_t lead = 0; lead < pins_.size(); ++lead) context_.board.connect(pins_[lead], *leads_[lead]);
  for (const auto& key : keys_) registry.pressable.push_back(key.get());
}

void KeypadPart::hold(std::size_t key, bool down, SimTime t) {
  std::vector<bool> before;
  for (std::size_t lead = 0; lead < pins_.size(); ++lead) before.push_back(level(lead));
  const std::uint64_t bit = std::uint64_t{1} << key;
  state_.down = down ? state_.down | bit : state_.down & ~bit;
  for (std::size_t lead = 0; lead < pins_.size(); ++lead)
    if (context_.board.wants_edges(pins_[lead]) && level(lead) != before[lead])
      context_.board.schedule_edge(pins_[lead], level(lead), t);
}

bool KeypadPart::level(std::size_t lead) const {
  // All leads that the pressed keys connect to `lead`, one bit each.
  std::uint32_t joined = 1u << lead;
  const std::size_t columns = spec_.columns.size();
  for (std::uint32_t before = 0; joined != before;) {
    before = joined;
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      if ((state_.down >> key & 1) == 0) continue;
      const std::uint32_t both = 1u << key / columns | 1u << (spec_.rows.size() + key % columns);
      if (joined & both) joined |= both;
    }
  }
  bool pulled_up = false;
  for (std::size_t other = 0; other < pins_.size(); ++other) {
    if ((joined >> other & 1) == 0) continue;
    const PinDrive& drive = context_.board.drive(pins_[other]);
    if (drive.mode == PinMode::output) return drive.level;
    pulled_up |= drive.mode == PinMode::input_pullup;
  }
  return pulled_up;
}

void KeypadPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.down ? 1.0 : 0.0});
}

}  // namespace robosim::robot
