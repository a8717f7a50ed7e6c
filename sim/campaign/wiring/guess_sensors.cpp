#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {
namespace {

using Pins = std::vector<const PinEvidence*>;

// Returns whether a pin has a meaningful name. Names such as `inPin`, or `pins` of the array `int pins[] =
// {2, 3, 13}`, are not meaningful.
bool is_named(const PinEvidence& clue) {
  const auto says_nothing = [](const std::string& word) {
    return word == "pin" || word == "pins" || word == "in" || word == "io" || word == "input" ||
           word == "inputs" || word == "port" || word == "ports" || word == "all";
  };
  return !clue.name.empty() && !(std::all_of(clue.words.begin(), clue.words.end(), says_nothing));
}

bool is_sensor_like(const Evidence& evidence, const PinEvidence& clue) {
  if (!clue.is_read() || clue.facts->toned) return false;
  // Encoders, buttons and remote-control receivers use these functions. For line sensors, edges are useless.
  if (evidence.is_given_to({"attachInterrupt", "digitalPinToInterrupt", "pulseIn"}, clue.pin)) return false;
  if (clue.name.empty() && evidence.is_given_to({"randomSeed"}, clue.pin)) return false;
  if (clue.name.empty() && is_of_serial(evidence.board(), clue.pin)) return false;
  if (clue.facts->driven && !clue.facts->discharged) return false;
  if (says(clue.words, {"butt",   "btn",   "switch", "sw",     "start",  "push", "bump",  "echo",    "trig",
                        "enc",    "batt",  "vbat",   "volt",   "pot",    "dist", "sharp", "sonar",   "ultra",
                        "rx",     "tx",    "mode",   "key",    "temp",   "curr", "recv",  "receive", "remote",
                        "knob",   "regl",  "trim",   "color",  "colour", "cor",  "vcc",   "knopf",   "taster",
                        "bouton", "boton", "botao",  "tombol", "dugme"}))
    return false;
  if (clue.facts->measured || clue.facts->discharged) return true;
  const bool named = says(clue.words, {"sens", "ir", "line", "track", "tcrt", "qtr", "left", "right", "mid",
                                       "cent", "s", "l", "r", "c", "m"});
  return named || (!clue.facts->pulled_up && !is_named(clue));
}

// Returns the position that the name describes, from left to right: far left, left, half left, middle and so
// on.
int place_of(const PinEvidence& clue) {
  const int far = says(clue.words, {"far", "out", "most", "extr", "ll", "rr"}) ? 3
                  : says(clue.words, {"mid", "mei", "med", "mil", "mitt", "orta", "tengah", "centr", "cent",
                                      "inn", "int", "semi", "half"})
                      ? 1
                      : 2;
  switch (side_of(clue.words)) {
    case Side::left:
      return -far;
    case Side::right:
      return far;
    case Side::unknown:
      return 0;
  }
  return 0;
}

// Returns the sensors in the order of an array that contains all of them. Elements may also have names of
// their own.
Pins in_order_of_array(const Evidence& evidence, Pins sensors) {
  const auto sort_by = [&](const std::vector<Pin>& array) {
    const auto place = [&](const PinEvidence* clue) {
      return std::find(array.begin(), array.end(), clue->pin) - array.begin();
    };
    const auto size = static_cast<std::ptrdiff_t>(array.size());
    if (sensors.size() < 2 || std::any_of(sensors.begin(), sensors.end(),
                                          [&](const PinEvidence* clue) { return place(clue) == size; }))
      return;
    std::stable_sort(sensors.begin(), sensors.end(),
                     [&](const PinEvidence* a, const PinEvidence* b) { return place(a) < place(b); });
  };
  for (const Given& given : evidence.names().given)
    for (const std::vector<Pin>& array : given.each) sort_by(array);
  for (const Named& named : evidence.names().named) sort_by(named.pins);
  return sensors;
}

// Sorts sensors by the numbers at the end of their names, if they differ in nothing else: S0, S1, S2.
void sort_by_number(Pins& sensors) {
  std::map<int, const PinEvidence*> numbered;
  std::vector<std::string> stem;
  for (const PinEvidence* clue : sensors) {
    std::vector<std::string> words = clue->words;
    if (clue->is_side_from_source) words.erase(words.begin());
    if (words.size() < 2 || words.back().size() > 2 ||
        words.back().find_first_not_of("0123456789") != std::string::npos)
      return;
    const int number = std::stoi(words.back());
    words.pop_back();
    if (words.size() > 1 && (words.back() == "a" || words.back() == "d"))
      words.pop_back();  // the letter of A1 or D7
    if (stem.empty()) stem = words;
    if (words != stem || !numbered.emplace(number, clue).second) return;
  }
  sensors.clear();
  for (const auto& [number, clue] : numbered) sensors.push_back(clue);
}

const char* kind_of(const PinEvidence& sensor) {
  return sensor.facts->measured ? "analog" : sensor.facts->discharged ? "rc" : "digital";
}

// Returns the sensors in the array that a library for line sensors reads; empty without such an array.
Pins of_library(const Evidence& evidence, const Pins& sensors) {
  for (const Given& given : evidence.names().given) {
    if (given.type != "setSensorPins" && !given.type.starts_with("QTRSensors")) continue;
    for (const std::vector<Pin>& array : given.each) {
      Pins inside;
      for (const PinEvidence* clue : sensors)
        if (std::count(array.begin(), array.end(), clue->pin) != 0) inside.push_back(clue);
      if (inside.size() > 1) return inside;
    }
  }
  return {};
}

// Returns whether the sensors have the same name except for a number, or are the elements of one array.
bool is_one_series(const Evidence& evidence, const Pins& sensors) {
  const auto has_all = [&](const std::vector<Pin>& array) {
    return std::all_of(sensors.begin(), sensors.end(), [&](const PinEvidence* clue) {
      return std::count(array.begin(), array.end(), clue->pin) != 0;
    });
  };
  for (const Named& named : evidence.names().named)
    if (named.is_array && has_all(named.pins)) return true;
  const auto stem_of = [](const PinEvidence* clue) {
    WordList words = clue->words;
    std::erase_if(words, [](const std::string& word) {
      return word.size() == 1 || std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    });
    return words;
  };
  const auto is_numbered = [](const PinEvidence* clue) {
    return !clue->words.empty() && std::isdigit(static_cast<unsigned char>(clue->words.back()[0])) != 0;
  };
  return !stem_of(sensors.front()).empty() &&
         std::all_of(sensors.begin(), sensors.end(), [&](const PinEvidence* clue) {
           return is_numbered(clue) && stem_of(clue) == stem_of(sensors.front());
         });
}

// Returns the sensors that form one array: a library's sensors, a series, or the sensors of the most frequent
// kind. The other sensors become parts of their own.
Pins alike(const Evidence& evidence, const Pins& sensors) {
  if (sensors.empty()) return {};
  Pins most = of_library(evidence, sensors);
  if (!most.empty()) return most;
  const bool has_rc = std::any_of(sensors.begin(), sensors.end(), [](const PinEvidence* clue) {
    return std::string("rc") == kind_of(*clue);
  });
  if (!has_rc && is_one_series(evidence, sensors)) return sensors;
  for (const std::string kind : {"analog", "rc", "digital"}) {
    Pins same;
    std::copy_if(sensors.begin(), sensors.end(), std::back_inserter(same),
                 [&](const PinEvidence* clue) { return kind == kind_of(*clue); });
    if (same.size() > most.size()) most = same;
  }
  return most;
}

// Returns how the sensors are read: their common kind. If the kinds differ, returns digital, or analog if one
// of the pins is only an analog input.
std::string kind_of_all(const Evidence& evidence, const Pins& sensors) {
  const std::string kind = kind_of(*sensors.front());
  const bool is_same = std::all_of(sensors.begin(), sensors.end(),
                                   [&](const PinEvidence* clue) { return kind == kind_of(*clue); });
  const bool has_analog_input = std::any_of(sensors.begin(), sensors.end(), [&](const PinEvidence* clue) {
    return !evidence.board().pins[clue->pin].digital;
  });
  return is_same ? kind : has_analog_input ? "analog" : "digital";
}

// Values of the stock robots: the distance between two elements, their distance ahead of the axle, and their
// footprint.
struct Layout {
  const char* pitch;
  const char* ahead;
  const char* footprint;
};
Layout layout_of(std::size_t count, bool close) {
  if (count == 2 && close) return {"12 mm", "60 mm", "4 mm"};
  if (count >= 4) return {"9.525 mm", "70 mm", "6 mm"};
  return count == 2 ? Layout{"36 mm", "60 mm", "5 mm"} : Layout{"22 mm", "65 mm", "5 mm"};
}

constexpr std::size_t kMostElements = 16;

// Adds the level over black, from the source or as a question.
void add_level(const Evidence& evidence, const Ways& ways, const std::string& kind, RobotDraft& draft,
               PartDraft& part) {
  const std::optional<StatedLevel>& stated = evidence.names().level;
  draft.open.black_low = kind != "rc" && !stated;
  const bool is_low = stated ? kind != "rc" && !stated->is_high : ways.black_low;
  if (is_low) part.keys.emplace_back("black", "\"low\"");
  if (kind != "rc" && stated)
    part.notes.push_back(fmt::format("{} over black: {}", stated->is_high ? "HIGH" : "LOW", stated->why));
  if (draft.open.black_low && !ways.black_low)
    part.doubts.push_back("HIGH over black is guessed; if it is LOW, add black = \"low\"");
  if (draft.open.black_low && ways.black_low) part.doubts.push_back(fmt::format("black: {}", kByTrial));
}

// Sorts the sensors from left to right. Returns whether their names determine the order. If only some have a
// place, the others keep the order of their numbers or of their array.
bool arrange(Pins& sensors) {
  const auto is_left = [](const PinEvidence* clue) { return place_of(*clue) < 0; };
  const auto is_right = [](const PinEvidence* clue) { return place_of(*clue) > 0; };
  const auto is_before = [](const PinEvidence* a, const PinEvidence* b) {
    return place_of(*a) < place_of(*b);
  };
  const auto left = std::count_if(sensors.begin(), sensors.end(), is_left);
  const auto right = std::count_if(sensors.begin(), sensors.end(), is_right);
  const auto count = static_cast<std::ptrdiff_t>(sensors.size());
  const bool is_placed = left > 0 && right > 0;
  if (is_placed && count - left - right <= 1) {
    std::stable_sort(sensors.begin(), sensors.end(), is_before);
    return true;
  }
  sort_by_number(sensors);
  // One sensor with a named side is enough, if it is at an end.
  const bool is_end =
      count > 2 && left + right == 1 && (place_of(*sensors.front()) != 0 || place_of(*sensors.back()) != 0);
  if (!is_placed && !is_end) return false;
  const auto place = [&](const auto& is) { return std::find_if(sensors.begin(), sensors.end(), is); };
  if (is_placed ? place(is_right) < place(is_left) : is_right(sensors.front()) || is_left(sensors.back()))
    std::reverse(sensors.begin(), sensors.end());
  if (is_placed && place(is_right) < place(is_left)) return false;
  return true;
}

}  // namespace

void guess_sensors(Evidence& evidence, const Ways& ways, RobotDraft& draft) {
  Pins sensors;
  for (const PinEvidence* clue : evidence.left())
    if (is_sensor_like(evidence, *clue)) sensors.push_back(clue);
  const auto has_name = [](const PinEvidence* clue) { return is_named(*clue); };
  if (std::count_if(sensors.begin(), sensors.end(), has_name) > 1)
    std::erase_if(sensors, [&](const PinEvidence* clue) { return !has_name(clue); });
  sensors = in_order_of_array(evidence, alike(evidence, sensors));
  if (sensors.empty() || sensors.size() > kMostElements) return;
  const bool placed = arrange(sensors);
  const std::string kind = kind_of_all(evidence, sensors);
  const Layout layout = layout_of(sensors.size(), ways.close);
  std::string pins, why;
  for (const PinEvidence* clue : sensors) {
    pins += (pins.empty() ? "" : ", ") + evidence.toml(clue->pin);
    if (why.find(clue->name) == std::string::npos) why += (why.empty() ? "" : ", ") + clue->name;
  }
  PartDraft part{
      part_name(draft, "S"), sensors.size() == 1 ? "reflectance" : "reflectance-array", {}, why, {}};
  part.keys.emplace_back("read", fmt::format("\"{}\"", kind));
  if (sensors.size() == 1) {
    part.keys.emplace_back("pin", pins);
  } else {
    part.keys.emplace_back("pins", "[" + pins + "]");
    part.keys.emplace_back("pitch", fmt::format("\"{}\"", layout.pitch));
    part.doubts.push_back(
        "measure pitch (the distance between neighbours) and at (the distance ahead of the axle)");
  }
  part.keys.emplace_back("at", fmt::format("[\"{}\", \"0 mm\"]", layout.ahead));
  part.keys.emplace_back("footprint", fmt::format("\"{}\"", layout.footprint));
  draft.open.other_order = !placed && sensors.size() > 1;
  draft.open.close = sensors.size() == 2;
  add_level(evidence, ways, kind, draft, part);
  if (ways.other_order) part.keys.emplace_back("first", "\"right\"");
  if (draft.open.other_order && !ways.other_order)
    part.doubts.push_back(
        "the order from left to right is guessed; if it is the reverse, add first = \"right\"");
  if (ways.other_order) part.doubts.push_back(fmt::format("first: {}", kByTrial));

  for (const PinEvidence* clue : evidence.left()) {
    if (!clue->facts->driven || !says(clue->words, {"emit", "irled", "ledon"})) continue;
    part.keys.emplace_back("emitter", evidence.toml(clue->pin));
    evidence.take(clue->pin);
    break;
  }
  for (const PinEvidence* clue : sensors) evidence.take(clue->pin);
  draft.parts.push_back(std::move(part));
  draft.base = kind == "digital" || sensors.size() < 4 ? "uno3" : "uno5";
}

}  // namespace robosim::wiring
