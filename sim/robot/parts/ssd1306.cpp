#include "sim/robot/parts/ssd1306.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/robot/parts/pixel_text.h"

namespace robosim::robot {
namespace {

constexpr int kUsualOledAddress = 0x3C;

// Returns the number of a command's arguments (table 9-1).
int arguments_of(std::uint8_t command) {
  switch (command) {
    case 0x20:
    case 0x81:
    case 0x8D:
    case 0xA8:
    case 0xD3:
    case 0xD5:
    case 0xD9:
    case 0xDA:
    case 0xDB:
      return 1;
    case 0x21:
    case 0x22:
    case 0xA3:
      return 2;
    case 0x29:
    case 0x2A:
      return 5;
    case 0x26:
    case 0x27:
      return 6;
    default:
      return 0;
  }
}

}  // namespace

std::shared_ptr<const PartSpec> read_ssd1306(PartReader& reader) {
  auto spec = std::make_shared<Ssd1306Spec>();
  spec->address = read_two_wire(reader, kUsualOledAddress);
  spec->height = static_cast<int>(reader.table().integer("height", 64, 16, 64));
  return reader.finish(spec);
}

std::unique_ptr<Part> Ssd1306Spec::make(PartContext& context) const {
  return std::make_unique<Ssd1306Part>(*this, context);
}

Ssd1306Part::Ssd1306Part(const Ssd1306Spec& spec, PartContext& context) : spec_(spec), context_(context) {
  context.snapshots.add(state_);
}

void Ssd1306Part::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.text_outputs.push_back(this);
}

bool Ssd1306Part::address(std::uint8_t address, bool, SimTime) {
  state_.expects = Expects::control;
  return address == spec_.address;
}

bool Ssd1306Part::write(std::uint8_t byte, SimTime t) {
  switch (state_.expects) {
    case Expects::control:
      state_.expects = byte & 0x40 ? (byte & 0x80 ? Expects::data_byte : Expects::data)
                                   : (byte & 0x80 ? Expects::command : Expects::commands);
      return true;
    case Expects::command:
    case Expects::commands:
      command(byte);
      break;
    case Expects::data_byte:
    case Expects::data:
      put(byte);
  }
  if (state_.expects == Expects::command || state_.expects == Expects::data_byte)
    state_.expects = Expects::control;
  state_.changed_at = t;
  return true;
}

void Ssd1306Part::command(std::uint8_t byte) {
  if (state_.count == 0) state_.wanted = 1 + arguments_of(byte);
  state_.words[static_cast<std::size_t>(state_.count++)] = byte;
  if (state_.count < state_.wanted) return;
  carry_out();
  state_.count = 0;
}

void Ssd1306Part::carry_out() {
  const std::uint8_t code = state_.words[0];
  const int first = state_.words[1], second = state_.words[2];
  if (code < 0x10) {
    state_.column = (state_.column & 0xF0) | code;
  } else if (code < 0x20) {
    state_.column = (state_.column & 0x0F) | (code & 0x07) << 4;
  } else if (code == 0x20) {
    state_.mode = first & 3;
  } else if (code == 0x21) {
    state_.column = state_.first_column = first % kWidth;
    state_.last_column = second % kWidth;
  } else if (code == 0x22) {
    state_.page = state_.first_page = first % kPages;
    state_.last_page = second % kPages;
  } else if (code == 0xA4 || code == 0xA5) {
    state_.all = code & 1;
  } else if (code == 0xA6 || code == 0xA7) {
    state_.inverse = code & 1;
  } else if (code == 0xAE || code == 0xAF) {
    state_.on = code & 1;
  } else if (code >= 0xB0 && code < 0xB0 + kPages) {
    state_.page = code - 0xB0;
  }
}

void Ssd1306Part::put(std::uint8_t byte) {
  state_.memory[static_cast<std::size_t>(state_.page * kWidth + state_.column)] = byte;
  const auto next_column = [this] {
    const bool wraps = state_.column == state_.last_column;
    state_.column = wraps ? state_.first_column : (state_.column + 1) % kWidth;
    return wraps;
  };
  const auto next_page = [this] {
    const bool wraps = state_.page == state_.last_page;
    state_.page = wraps ? state_.first_page : (state_.page + 1) % kPages;
    return wraps;
  };
  if (state_.mode == 0) {
    if (next_column()) next_page();
  } else if (state_.mode == 1) {
    if (next_page()) next_column();
  } else {
    state_.column = (state_.column + 1) % kWidth;
  }
}

bool Ssd1306Part::lit(int x, int y) const {
  if (!state_.on) return false;
  if (state_.all) return true;
  const bool bit = state_.memory[static_cast<std::size_t>(y / 8 * kWidth + x)] >> y % 8 & 1;
  return bit != state_.inverse;
}

std::string Ssd1306Part::picture() const {
  int count = 0, left = kWidth, right = 0, top = spec_.height, bottom = 0;
  for (int y = 0; y < spec_.height; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (!lit(x, y)) continue;
      ++count;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  if (count == 0) return {};
  Pixels pixels{kWidth, spec_.height, {}};
  for (int y = 0; y < spec_.height; ++y)
    for (int x = 0; x < kWidth; ++x) pixels.lit.push_back(lit(x, y) ? 1 : 0);
  const std::string text = text_in(std::move(pixels));
  return fmt::format("{} lit in {},{} to {},{}{}{}", count, left, top, right, bottom,
                     text.empty() ? "" : ": ", text);
}

std::string Ssd1306Part::poll_text(SimTime t) {
  if (!state_.text.is_due(state_.changed_at, t)) return {};
  return state_.text.poll_text(state_.changed_at, picture());
}

void Ssd1306Part::read(std::vector<Reading>& readings) const {
  int count = 0;
  for (int y = 0; y < spec_.height; ++y)
    for (int x = 0; x < kWidth; ++x) count += lit(x, y) ? 1 : 0;
  readings.push_back({spec_.name, static_cast<double>(count)});
}

}  // namespace robosim::robot
