#include "sim/campaign/wiring/guess.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::wiring {
namespace {

std::string use_of(const PinFacts& facts) {
  std::string text;
  const auto add = [&](bool is, const char* what) {
    if (is) text += fmt::format("{}{}", text.empty() ? "" : " and ", what);
  };
  add(facts.pwm, "driven by analogWrite");
  add(facts.driven && !facts.pwm, "driven");
  add(facts.measured, "measured");
  add(facts.looked, "read");
  add(facts.pulled_up && !facts.looked, "pulled up");
  return text;
}

void add_pin_part(Evidence& evidence, RobotDraft& draft, const PinEvidence& clue, const char* type,
                  const char* otherwise, std::vector<std::pair<std::string, std::string>> keys = {}) {
  PartDraft part{part_name(draft, clue.name.empty() || clue.in_array ? otherwise : clue.name),
                 type,
                 {{"pin", evidence.toml(clue.pin)}},
                 evidence.where(clue.pin),
                 {}};
  part.keys.insert(part.keys.end(), keys.begin(), keys.end());
  draft.parts.push_back(std::move(part));
  evidence.take(clue.pin);
}

void guess_input(Evidence& evidence, RobotDraft& draft, const PinEvidence& clue) {
  const bool low = clue.facts->pulled_up;
  const std::vector<Pin>& flags = evidence.names().flag_interrupts;
  const bool is_flag = low && std::count(flags.begin(), flags.end(), clue.pin) != 0;
  if (says(clue.words, {"enc"}) ||
      (evidence.is_given_to({"attachInterrupt", "digitalPinToInterrupt"}, clue.pin) && !is_flag &&
       !says(clue.words, {"butt", "btn", "start", "sw"}))) {
    PartDraft part{part_name(draft, clue.name.empty() ? "encoder" : clue.name),
                   "encoder",
                   {{"pins", fmt::format("{{ a = {} }}", evidence.toml(clue.pin))}},
                   evidence.where(clue.pin),
                   {}};
    add_wheel_and_periods(draft, side_of(clue.words), part);
    draft.parts.push_back(std::move(part));
    evidence.take(clue.pin);
  } else if (says(clue.words, {"bump", "collis", "whisk", "limit"})) {
    low ? add_pin_part(evidence, draft, clue, "bumper", "bumper")
        : add_pin_part(evidence, draft, clue, "bumper", "bumper", {{"resistor", "true"}});
  } else if (says(clue.words, {"in", "mot", "dir", "pwm"})) {
    return;  // a driver's input, by its name, but never set to OUTPUT: becomes a question
  } else if (low || says(clue.words, {"butt", "btn", "switch", "sw", "start", "push", "key", "mode", "knopf",
                                      "taster", "bouton", "boton", "botao", "tombol", "dugme"})) {
    low ? add_pin_part(evidence, draft, clue, "button", "button")
        : add_pin_part(evidence, draft, clue, "button", "button", {{"resistor", "true"}});
    if (!low)
      draft.parts.back().doubts.push_back(
          "LOW when pressed, with its own resistor; if it is HIGH when pressed, add active = \"high\"");
  }
}

void guess_measured(Evidence& evidence, RobotDraft& draft, const PinEvidence& clue) {
  if (says(clue.words, {"batt", "vbat", "volt"})) {
    add_pin_part(evidence, draft, clue, "voltage", "battery", {{"share", "0.5"}});
    draft.parts.back().doubts.push_back("share: the ratio of the voltage divider");
  } else if (says(clue.words, {"dist", "sharp"})) {
    add_pin_part(evidence, draft, clue, "ir-distance", "distance");
  } else if (says(clue.words, {"curr"})) {
    add_pin_part(evidence, draft, clue, "current-sensor", "current");
  } else if (says(clue.words, {"pot", "trim", "knob", "regl"})) {
    add_pin_part(evidence, draft, clue, "voltage", "knob", {{"volts", "\"2.5 V\""}});
  }
}

void guess_output(Evidence& evidence, RobotDraft& draft, const PinEvidence& clue) {
  if (clue.facts->toned || says(clue.words, {"buzz", "beep", "speak", "piezo", "tone", "buzin"})) {
    clue.facts->toned ? add_pin_part(evidence, draft, clue, "buzzer", "buzzer")
                      : add_pin_part(evidence, draft, clue, "buzzer", "buzzer", {{"passive", "false"}});
  } else if (clue.facts->pulses && says(clue.words, {"servo", "grip", "claw", "pinza", "garra"})) {
    add_pin_part(evidence, draft, clue, "servo", "servo");
  } else if (says(clue.words, {"led", "light", "lamp"})) {
    add_pin_part(evidence, draft, clue, "led", "LED");
  } else if (clue.pin == evidence.board().led_builtin && clue.name.empty()) {
    add_pin_part(evidence, draft, clue, "led", "LED");
    draft.parts.back().doubts.push_back("the LED of the board, unless something else is wired to this pin");
  }
}

// Returns "pin 5" or "pin A0".
std::string shown(const Evidence& evidence, Pin pin) {
  const std::string name = evidence.board().pins[pin].name;
  return "pin " + (name[0] == 'D' ? name.substr(1) : name);
}

// Adds a question about the two-wire bus if the sketch uses the bus. The library Wire only enables the
// pull-ups of the bus's pins, and never reads them as pins.
void ask_for_the_bus(Evidence& evidence, RobotDraft& draft) {
  const TwiSpec& bus = evidence.board().chip->twi;
  if (bus.address == 0) return;
  const Pin data = find_pin(evidence.board(), bus.data), clock = find_pin(evidence.board(), bus.clock);
  for (const Pin pin : {data, clock}) {
    const PinFacts& facts = *evidence.of(pin).facts;
    if (!evidence.is_free(pin) || !facts.pulled_up || facts.looked || facts.driven || facts.measured) return;
  }
  evidence.take(data);
  evidence.take(clock);
  draft.questions.push_back(fmt::format(
      "{} and {} are used as the two-wire bus (Wire): what is connected to it? Parts for it are lcd-i2c, "
      "ssd1306, mpu-6050, vl53l0x, tcs34725 and pca9685",
      shown(evidence, data), shown(evidence, clock)));
}

// For each name, adds a question about its pins that were not used in the runs.
void ask_for_unused(const Evidence& evidence, RobotDraft& draft) {
  std::vector<std::pair<std::string, std::string>> names;  // where a name is, and its pins
  for (const PinEvidence* clue : evidence.never_used()) {
    const std::string where = evidence.where(clue->pin), pin = shown(evidence, clue->pin);
    if (!names.empty() && !where.empty() && names.back().first == where)
      names.back().second += ", " + pin.substr(pin.find(' ') + 1);
    else
      names.emplace_back(where, pin);
  }
  for (const auto& [where, pins] : names)
    draft.questions.push_back(fmt::format("{}{} {} not used in the runs: when does the sketch use {}?", pins,
                                          where.empty() ? "" : " (" + where + ")",
                                          pins.find(',') == pins.npos ? "was" : "were",
                                          pins.find(',') == pins.npos ? "it" : "them"));
}

}  // namespace

std::string part_name(const RobotDraft& draft, const std::string& wanted) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(draft.parts.begin(), draft.parts.end(),
                       [&](const PartDraft& p) { return p.name == name; });
  };
  constexpr std::size_t kLongest = 36;  // the limit is 40, and a number may follow
  std::string plain;
  for (const char c : wanted)
    if (c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0) plain += c;
  plain = plain.empty() ? "part" : plain.substr(0, kLongest);
  // The elements of the array S are S1, S2 …
  if (plain.size() > 1 && plain[0] == 'S' && plain.find_first_not_of("0123456789", 1) == std::string::npos)
    plain = "part_" + plain;
  std::string name = plain;
  for (int n = 2; taken(name); ++n) name = fmt::format("{}_{}", plain, n);
  return name;
}

void add_wheel_and_periods(const RobotDraft& draft, Side side, PartDraft& encoder) {
  encoder.keys.emplace_back("periods", "20");
  encoder.doubts.push_back("periods: the periods of one channel for each turn of the wheel");
  if (side == Side::unknown) {
    const bool has_left = std::any_of(draft.parts.begin(), draft.parts.end(),
                                      [](const PartDraft& p) { return p.type == "encoder"; });
    side = has_left ? Side::right : Side::left;
    encoder.doubts.push_back("wheel: guessed from the order of the encoders");
  }
  encoder.keys.emplace_back("wheel", side == Side::left ? "\"left\"" : "\"right\"");
}

// Converts two servos that are named after the sides to wheel servos, if nothing else can drive the wheels.
// On a robot with motors, servos with such names move a gripper, an arm or a flag.
void guess_wheel_servos(RobotDraft& draft) {
  PartDraft *left = nullptr, *right = nullptr;
  for (PartDraft& part : draft.parts) {
    if (part.type == "motor") return;
    if (part.type != "servo") continue;
    const Side side = side_of(words_of(part.name));
    if (side == Side::left && left == nullptr) left = &part;
    if (side == Side::right && right == nullptr) right = &part;
  }
  if (left == nullptr || right == nullptr) return;
  for (PartDraft* const part : {left, right})
    if (spelled_side(words_of(part->name)) == Side::unknown)
      part->doubts.push_back("which servo is the left one is guessed from its name");
  left->type = right->type = "wheel-servo";
  left->name = right->name = "";
  left->name = part_name(draft, "left");
  right->name = part_name(draft, "right");
  draft.driver = "servo";
}

void guess_the_rest(Evidence& evidence, RobotDraft& draft) {
  ask_for_the_bus(evidence, draft);
  for (const PinEvidence* clue : evidence.left()) {
    if (clue->facts->driven)
      guess_output(evidence, draft, *clue);
    else if (clue->facts->measured)
      guess_measured(evidence, draft, *clue);
    else
      guess_input(evidence, draft, *clue);
  }
  for (const PinEvidence* clue : evidence.left()) {
    if (clue->is_assumed) continue;  // has a question of its own
    if (is_of_serial(evidence.board(), clue->pin) || evidence.is_given_to({"randomSeed"}, clue->pin))
      continue;
    const std::string where = evidence.where(clue->pin);
    draft.questions.push_back(fmt::format("{}{} is {}: what is wired to it?", shown(evidence, clue->pin),
                                          where.empty() ? "" : " (" + where + ")", use_of(*clue->facts)));
  }
  ask_for_unused(evidence, draft);
}

// Adds a question about a level over black that was derived from names such as turnLeft(). Applies only if
// the sides of the motors are unknown.
void ask_for_level(const Evidence& evidence, RobotDraft& draft) {
  const std::optional<StatedLevel>& level = evidence.names().level;
  if (!draft.open.other_sides || !level || !level->is_by_turns) return;
  for (PartDraft& part : draft.parts)
    if (part.type.starts_with("reflectance"))
      part.doubts.push_back(
          "black: the level follows from the names of turns, but the motors' sides are open");
}

RobotDraft guess(const BoardSpec& board, const SketchNames& names, const PinHistory& history,
                 const Ways& ways) {
  RobotDraft draft;
  draft.ways = ways;
  draft.board = board.name;
  draft.base = "uno3";
  draft.driver = "l298n";
  Evidence evidence(board, names, history);
  guess_shields(evidence, ways, draft);
  guess_by_libraries(evidence, draft);
  guess_sensors(evidence, ways, draft);
  guess_motors(evidence, ways, draft);
  ask_for_level(evidence, draft);
  guess_wheel_servos(draft);
  guess_the_rest(evidence, draft);
  draft.open.low_battery = std::any_of(draft.parts.begin(), draft.parts.end(),
                                       [](const PartDraft& part) { return part.type == "motor"; });
  if (ways.low_battery) draft.supply = "\"6 V\"";
  const auto rank = [](const PartDraft& part) {
    return part.type.find("motor") != std::string::npos || part.type == "wheel-servo" ? 0
           : part.type.rfind("reflect", 0) == 0                                       ? 1
                                                                                      : 2;
  };
  std::stable_sort(draft.parts.begin(), draft.parts.end(),
                   [&](const PartDraft& a, const PartDraft& b) { return rank(a) < rank(b); });
  return draft;
}

}  // namespace robosim::wiring
