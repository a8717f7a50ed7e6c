#include "sim/wiring/pin_evidence.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/wiring/tokens.h"

namespace robosim::wiring {
namespace {

bool is_one_of(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

// Matches lm, rmf, lpwm, rsensor: a letter, followed by a name of one motor or sensor.
bool begins_side(const std::string& word, char letter) {
  static const std::initializer_list<const char*> rests = {
      "",    "f",   "b",   "s",   "d",   "w",     "en",    "in",    "ir",    "fwd",
      "bwd", "rev", "pwm", "dir", "enc", "speed", "wheel", "servo", "sensor"};
  constexpr std::size_t kLongestShort = 4;
  if (word.empty() || word[0] != letter) return false;
  const bool is_motor = word.size() > 1 && word[1] == 'm';
  if (is_motor && (word.size() <= kLongestShort || word.substr(1, 3) == "mot")) return true;
  return is_one_of(word.substr(1), rests);
}

Side numbered(const std::string& number, bool four) {
  if (number == "1" || (four && number == "2")) return Side::left;
  if (number == "2" || (four && (number == "3" || number == "4"))) return Side::right;
  return Side::unknown;
}

}  // namespace

Side side_of(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word.rfind("left", 0) == 0 ||
        is_one_of(word, {"lft", "izq", "izquierda", "izquierdo", "gauche", "links", "kiri"}))
      return Side::left;
    if (word.rfind("right", 0) == 0 ||
        is_one_of(word, {"rgt", "rt", "der", "derecha", "derecho", "droite", "rechts", "kanan"}))
      return Side::right;
  }
  for (const std::string& word : words) {
    if (begins_side(word, 'l') || is_one_of(word, {"lt"})) return Side::left;
    if (begins_side(word, 'r')) return Side::right;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_one_of(words[i], {"a", "ena", "pwma", "ain", "motora", "dira", "speeda", "ma"})) return Side::left;
    if (is_one_of(words[i], {"b", "enb", "pwmb", "bin", "motorb", "dirb", "speedb", "mb"}))
      return Side::right;
    if (i + 1 == words.size()) break;
    const bool is_input = is_one_of(words[i], {"in", "input"});
    if (!is_input && !is_one_of(words[i], {"m", "e", "motor", "en", "dir", "pwm", "speed", "wheel"}))
      continue;
    if (const Side side = numbered(words[i + 1], is_input); side != Side::unknown) return side;
  }
  return Side::unknown;
}

bool says(const std::vector<std::string>& words, std::initializer_list<const char*> beginnings) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const char* one) { return word.rfind(one, 0) == 0; });
  });
}

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
