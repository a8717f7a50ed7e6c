#include "sim/campaign/wiring/pin_evidence.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::wiring {
namespace {

using namespace std::string_literals;

// Replaces letters that mean a side by words, if other names of the sketch confirm this. Examples: in
// Spanish pwmi and pwmd with izq or der, in Portuguese motorE with motorD, in French motorG with motorD. A
// letter for the pin's use may follow: EV, DV. The outermost sensors have the letter twice: EE, DD.
void read_letters_as_sides(std::vector<PinEvidence>& pins) {
  const auto any = [&](const std::string& word) {
    return std::any_of(pins.begin(), pins.end(), [&](const PinEvidence& clue) {
      return std::find(clue.words.begin(), clue.words.end(), word) != clue.words.end();
    });
  };
  const bool is_spanish = std::any_of(pins.begin(), pins.end(), [](const PinEvidence& clue) {
    return says(clue.words, {"izq", "der"});
  });
  const bool has_no_other = !any("l") && !any("r");
  const auto replace = [](PinEvidence& clue, std::size_t i, char letter, const char* side) {
    std::string& word = clue.words[i];
    const bool is_double = word.size() == 2 && word[1] == letter;
    const bool has_use = word.size() == 2 && (word[1] == 'v' || word[1] == 'p');
    if (word[0] != letter || (word.size() > 1 && !is_double && !has_use)) return;
    word = side;
    if (is_double) clue.words.insert(clue.words.begin(), "far");
  };
  const bool is_portuguese = any("e") && any("d") && has_no_other;
  const bool is_french = any("g") && any("d") && has_no_other;
  for (PinEvidence& clue : pins) {
    if (spelled_side(clue.words) != Side::unknown) continue;
    for (std::size_t i = 0; i < clue.words.size(); ++i) {
      if (is_spanish && (clue.words[i] == "pwmi" || clue.words[i] == "i")) clue.words[i] = "izq";
      if (is_spanish && (clue.words[i] == "pwmd" || clue.words[i] == "d")) clue.words[i] = "der";
      if (is_portuguese) replace(clue, i, 'e', "esq");
      if (is_french) replace(clue, i, 'g', "gauche");
      if (is_portuguese || is_french) replace(clue, i, 'd', "direita");
    }
  }
}

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

// Returns whether an object has the pins of a whole robot, so that its name does not describe any of them.
bool is_too_general(const Given& given) {
  constexpr std::size_t kMost = 6;
  return given.pins.size() > kMost &&
         std::all_of(given.each.begin(), given.each.end(), [](const auto& pins) { return pins.size() < 2; });
}

// Returns the pins of an object. Next to an array of pins, a number is not a pin:
// QTRSensorsRC qtr((unsigned char[]){A0, A1}, 2, 2500).
std::vector<Pin> pins_with_names(const Given& given) {
  const bool has_array =
      std::any_of(given.each.begin(), given.each.end(), [](const auto& pins) { return pins.size() > 1; });
  if (!has_array) return given.pins;
  std::vector<Pin> pins;
  for (std::size_t i = 0; i < given.each.size(); ++i) {
    const bool is_name = std::isalpha(static_cast<unsigned char>(given.arguments[i][0])) != 0;
    if (given.each[i].size() > 1 || (is_name && !is_quantity(given.arguments[i])))
      pins.insert(pins.end(), given.each[i].begin(), given.each[i].end());
  }
  return pins;
}

// Returns the use of each pin by the calls in the source. A run need not reach these calls: the sketch may
// wait for a button, or for a byte.
std::vector<PinFacts> uses_in_source(const SketchNames& names, const BoardSpec& board) {
  std::vector<PinFacts> facts(board.pin_count);
  for (const Given& given : names.given)
    for (const Pin pin : pins_with_names(given)) {
      if (pin == kNoPin) continue;
      const bool is_analog = board.pins[pin].analog_channel >= 0;
      const bool is_of_array = given.type == "setSensorPins" || given.type.starts_with("QTRSensors");
      const bool is_rc = given.type == "QTRSensorsRC" || (is_of_array && !is_analog);
      facts[pin].measured |= given.type == "analogRead" || (is_of_array && !is_rc);
      facts[pin].looked |= given.type == "digitalRead" || (is_of_array && is_rc);
      facts[pin].discharged |= is_of_array && is_rc;
      facts[pin].pwm |= given.type == "analogWrite";
      facts[pin].driven |=
          given.type == "analogWrite" || given.type == "digitalWrite" || given.type == "OUTPUT";
    }
  return facts;
}

}  // namespace

Evidence::Evidence(const BoardSpec& board, const SketchNames& names, const PinHistory& history)
    : board_(board),
      names_(names),
      history_(history),
      by_pin_(board.pin_count),
      facts_(uses_in_source(names, board)) {
  const bool uses_servo = std::any_of(names.given.begin(), names.given.end(),
                                      [](const Given& given) { return given.type == "attach"; });
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    PinEvidence& clue = by_pin_[pin];
    clue.pin = pin;
    clue.facts = &facts_[pin];
    const bool is_read_in_source = facts_[pin].looked, is_in_source = clue.is_used();
    PinFacts seen = history.of(pin);
    seen.looked |= seen.looked_along && (is_read_in_source || names.reads_ports);
    // The library Servo reads flags of timers, which a run reports as reads of a pin.
    const bool is_of_library = std::any_of(names.given.begin(), names.given.end(), [&](const Given& given) {
      return std::count(given.pins.begin(), given.pins.end(), pin) != 0;
    });
    if (uses_servo && !names.reads_levels && !names.reads_ports && !is_of_library) seen.looked = false;
    const bool is_seen = seen.driven || seen.looked || seen.measured || seen.pulled_up;
    clue.is_assumed = is_in_source && !is_seen;
    // Without pinMode(), digitalWrite() only switches the pull-up.
    if (facts_[pin].driven && seen.pulled_up && !seen.driven && !seen.looked && !seen.measured)
      seen.driven = true;
    if (is_seen) facts_[pin] = seen;
  }
  add_names(history);
  read_dir_as_right(by_pin_);
  read_letters_as_sides(by_pin_);
  add_source_words();
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (by_pin_[pin].name.empty()) order_.push_back(pin);
}

// Names the pins. A name that is passed to a pin function takes precedence over a name whose value may be any
// number.
void Evidence::add_names(const PinHistory& history) {
  std::vector<std::size_t> rank(board_.pin_count);
  std::size_t next_rank = 0;
  const auto name = [&](Pin pin, const std::string& text, bool in_array, const Spot& spot) {
    PinEvidence& clue = by_pin_[pin];
    if (!clue.name.empty()) return;
    clue.name = text;
    clue.words = words_of(text);
    clue.in_array = in_array;
    clue.spot = spot;
    order_.push_back(pin);
    rank[pin] = next_rank;
  };
  for (const bool sure : {true, false}) {
    for (const Named& named : names_.named) {
      if (named.sure != sure) continue;
      next_rank = static_cast<std::size_t>(&named - names_.named.data());
      for (const Pin pin : named.pins) {
        const Pin channel = static_cast<Pin>(pin + board_.analog_pin_0);
        if (sure || by_pin_[pin].is_used())
          name(pin, named.name, named.is_array, named.spot);
        else if (channel < board_.pin_count && history.of(channel).measured)
          name(channel, named.name, named.is_array, named.spot);
      }
    }
  }
  std::stable_sort(order_.begin(), order_.end(), [&](Pin a, Pin b) { return rank[a] < rank[b]; });
  for (const Given& given : names_.given) {
    if (given.name.empty() || is_too_general(given)) continue;
    const std::vector<Pin> pins = pins_with_names(given);
    for (std::size_t i = 0; i < pins.size() && pins[i] != kNoPin; ++i) {
      PinEvidence& clue = by_pin_[pins[i]];
      if (!clue.is_used()) continue;
      name(clue.pin, given.name, false, given.spot);
      if (clue.argument < 0) {
        clue.argument = static_cast<int>(i);
        clue.object = &given;
      }
      const auto more = words_of(given.type);
      if (clue.name == given.name) clue.words.insert(clue.words.end(), more.begin(), more.end());
    }
  }
}

// Returns the side that the source names for all pins of a channel such as A. The channels A and B are on
// different sides. Returns unknown if the source contradicts itself.
Side side_of_channel(const std::map<Side, std::set<Side>>& named, Side channel) {
  const Side other = channel == Side::left ? Side::right : Side::left;
  const auto only = [&](Side one) {
    const auto sides = named.find(one);
    return sides != named.end() && sides->second.size() == 1 ? *sides->second.begin() : Side::unknown;
  };
  const auto is_open = [&](Side one) { return named.count(one) == 0; };
  const auto opposite = [](Side one) {
    return one == Side::left ? Side::right : one == Side::right ? Side::left : Side::unknown;
  };
  const Side own = only(channel), across = opposite(only(other));
  if (is_open(channel)) return across;
  return is_open(other) || own == across ? own : Side::unknown;
}

// Adds the sides and directions of pins whose names do not state them. The source's comments and functions
// provide these.
void Evidence::add_source_words() {
  std::map<Pin, Side> sides;
  std::map<Side, std::set<Side>> of_channel;  // key: the side that a channel such as A or 1 usually has
  const bool is_portuguese = std::any_of(names_.remarks.begin(), names_.remarks.end(),
                                         [](const auto& remark) { return says(remark.second, {"esq"}); });
  for (PinEvidence& clue : by_pin_) {
    const auto remark = names_.remarks.find(clue.pin);
    if (remark != names_.remarks.end()) {
      WordList words = remark->second;
      if (is_portuguese) std::replace(words.begin(), words.end(), "dir"s, "direita"s);
      if (clue.name.empty()) clue.words = words;
      const bool is_open = !says_forward(clue.words) && !says_backward(clue.words);
      const bool forward = function_goes_forward(words), backward = function_goes_backward(words);
      clue.is_direction_from_source = clue.name.empty() || is_open;
      if (is_open && forward != backward)
        clue.words.insert(clue.words.begin(), forward ? "forward" : "backward");
      sides[clue.pin] = only_side(words);
    }
    if (spelled_side(clue.words) != Side::unknown) continue;
    if (sides[clue.pin] == Side::unknown) sides[clue.pin] = side_in_blocks(names_.blocks, clue.pin);
    if (sides[clue.pin] != Side::unknown) of_channel[side_of(clue.words)].insert(sides[clue.pin]);
  }
  for (PinEvidence& clue : by_pin_) {
    if (spelled_side(clue.words) != Side::unknown) continue;
    const Side channel = side_of(clue.words);
    const Side side = channel == Side::unknown ? sides[clue.pin] : side_of_channel(of_channel, channel);
    if (side == Side::unknown) continue;
    // Numbers and letters of the name remain the last words.
    clue.words.insert(clue.words.begin(), side == Side::left ? "left" : "right");
    clue.is_side_from_source = true;
  }
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
    if (by_pin_[pin].is_assumed ||
        (!by_pin_[pin].is_used() && !by_pin_[pin].name.empty() && taken_.count(pin) == 0))
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
