#include "sim/campaign/wiring/pin_evidence.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/campaign/wiring/tokens.h"

namespace robosim::wiring {
namespace {

using namespace std::string_literals;

// Replaces the word `dir` by `direita` (right) if another name contains `esq`, which is left in Portuguese.
// In such a sketch, `dir` means right, not direction.
void read_dir_as_right(std::vector<PinEvidence>& pins) {
  const bool is_portuguese = std::any_of(pins.begin(), pins.end(),
                                         [](const PinEvidence& clue) { return says(clue.words, {"esq"}); });
  if (!is_portuguese) return;
  for (PinEvidence& clue : pins)
    if (spelled_side(clue.words) == Side::unknown)
      std::replace(clue.words.begin(), clue.words.end(), "dir"s, "direita"s);
}

}  // namespace

Evidence::Evidence(const BoardSpec& board, const SketchNames& names, const PinHistory& history)
    : board_(board), names_(names), history_(history), by_pin_(board.pin_count) {
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    by_pin_[pin].pin = pin;
    by_pin_[pin].facts = &history.of(pin);
  }
  const auto name = [&](Pin pin, const std::string& text, bool in_array, const Spot& spot) {
    PinEvidence& clue = by_pin_[pin];
    if (!clue.name.empty()) return;
    clue.name = text;
    clue.words = words_of(text);
    clue.in_array = in_array;
    clue.spot = spot;
    order_.push_back(pin);
  };
  for (const Named& named : names.named)
    for (const Pin pin : named.pins)
      if (named.sure || by_pin_[pin].is_used()) name(pin, named.name, named.is_array, named.spot);
  for (const Given& given : names.given) {
    if (given.name.empty()) continue;
    for (std::size_t i = 0; i < given.pins.size() && given.pins[i] != kNoPin; ++i) {
      PinEvidence& clue = by_pin_[given.pins[i]];
      if (!clue.is_used()) continue;
      name(clue.pin, given.name, false, given.spot);
      if (clue.argument < 0) clue.argument = static_cast<int>(i);
      const auto more = words_of(given.type);
      if (clue.name == given.name) clue.words.insert(clue.words.end(), more.begin(), more.end());
    }
  }
  read_dir_as_right(by_pin_);
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (by_pin_[pin].name.empty()) order_.push_back(pin);
}

std::vector<const PinEvidence*> Evidence::left() const {
  std::vector<const PinEvidence*> list;
  for (const Pin pin : order_)
    if (by_pin_[pin].is_used() && taken_.count(pin) == 0) list.push_back(&by_pin_[pin]);
  return list;
}

std::vector<const PinEvidence*> Evidence::never_used() const {
  std::vector<const PinEvidence*> list;
  for (const Pin pin : order_)
    if (!by_pin_[pin].is_used() && !by_pin_[pin].name.empty() && taken_.count(pin) == 0)
      list.push_back(&by_pin_[pin]);
  return list;
}

bool Evidence::is_given_to(std::initializer_list<const char*> functions, Pin pin) const {
  return std::any_of(names_.given.begin(), names_.given.end(), [&](const Given& given) {
    return !given.each.empty() && std::count(given.each[0].begin(), given.each[0].end(), pin) != 0 &&
           std::find(functions.begin(), functions.end(), given.type) != functions.end();
  });
}

std::string Evidence::toml(Pin pin) const {
  const std::string name = board_.pins[pin].name;
  return name[0] == 'D' ? name.substr(1) : fmt::format("\"{}\"", name);
}

std::string Evidence::where(Pin pin) const {
  const PinEvidence& clue = by_pin_[pin];
  return clue.name.empty() ? "" : fmt::format("{}, {}:{}", clue.name, clue.spot.file, clue.spot.line);
}

}  // namespace robosim::wiring
