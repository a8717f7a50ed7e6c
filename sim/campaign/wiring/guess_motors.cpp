#include <fmt/format.h>

#include <algorithm>

#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {
namespace {

using Pins = std::vector<const PinEvidence*>;

bool is_motor_like(const PinEvidence& clue) {
  if (!clue.facts->driven || clue.facts->toned || clue.facts->discharged || clue.in_array)
    return clue.in_array && clue.facts->driven && names_motor(clue.words);
  if (says(clue.words, {"led", "light", "lamp", "buzz", "beep", "speak", "piezo", "trig", "echo", "emit",
                        "senso", "debug"}))  // the French "sens" is a direction
    return false;
  if (names_motor(clue.words) || says(clue.words, {"pwm", "dir", "speed", "drive"})) return true;
  if (says_forward(clue.words) || says_backward(clue.words)) return true;
  return clue.facts->pwm || side_of(clue.words) != Side::unknown || clue.name.empty();
}

// Returns whether the sketch uses PWM on a pin. In the run, analogWrite(pin, 0) only sets a level, so calls
// in the source count, too.
bool is_pwm(const Evidence& evidence, const PinEvidence& clue) {
  return clue.facts->pwm || evidence.is_given_to({"analogWrite"}, clue.pin);
}

// Returns whether a pin is named like an enable input, without a side, and is almost always high. Such a pin
// is the driver's enable or standby input.
bool is_enable_of_both(const Evidence& evidence, const PinEvidence& clue) {
  constexpr double kMostly = 0.45;  // the result of lean() is at most 0.5
  return clue.facts->driven && !is_pwm(evidence, clue) && !clue.in_array && says(clue.words, {"en", "ena"}) &&
         !says(clue.words, {"enc"}) && side_of(clue.words) == Side::unknown &&
         evidence.history().lean(kNoPin, clue.pin, kNoPin) > kMostly;
}

// Returns whether the last word contains a side and this direction, as in rmf and lf. The B of motorB does
// not count as a direction.
bool is_short_for(const PinEvidence& clue, char direction) {
  constexpr std::size_t kLongest = 4;
  const bool is_channel = !clue.words.empty() && clue.words.back().size() == 1 &&
                          side_of(clue.words) != Side::unknown &&
                          side_of({clue.words.begin(), clue.words.end() - 1}) == Side::unknown;
  return !clue.words.empty() && !is_channel && clue.words.back().size() <= kLongest &&
         clue.words.back().back() == direction &&
         (clue.words.back().size() == 1 || side_of({clue.words.back()}) != Side::unknown);
}

bool is_forward(const PinEvidence& clue) {
  return says_forward(clue.words) || is_short_for(clue, 'f') || is_short_for(clue, 'p');
}

bool is_backward(const PinEvidence& clue) {
  return says_backward(clue.words) || is_short_for(clue, 'b') || is_short_for(clue, 'n');
}

int number_of(const PinEvidence& clue) {
  return clue.words.empty() || clue.words.back().empty() ||
                 std::isdigit(static_cast<unsigned char>(clue.words.back()[0])) == 0
             ? -1
             : std::stoi(clue.words.back().substr(0, 4));
}

// Returns 1 if a is the forward input, -1 if b is, 0 if their names do not determine it.
int named_order(const PinEvidence& a, const PinEvidence& b) {
  if (is_forward(a) != is_forward(b)) return is_forward(a) ? 1 : -1;
  if (is_backward(a) != is_backward(b)) return is_backward(a) ? -1 : 1;
  if (number_of(a) >= 0 && number_of(b) >= 0 && number_of(a) != number_of(b))
    return number_of(a) < number_of(b) ? 1 : -1;
  if (a.object == b.object && a.argument >= 0 && b.argument >= 0) return a.argument < b.argument ? 1 : -1;
  return 0;
}

// Returns whether the names end with the letters a and b. The letters then name channels, and b does not mean
// backward.
bool are_letters(const PinEvidence& a, const PinEvidence& b) {
  return !a.words.empty() && !b.words.empty() && a.words.back() == "a" && b.words.back() == "b";
}

// Returns whether a name means a direction. In Portuguese, "direita" is the right side.
bool is_direction(const PinEvidence& clue) {
  return std::any_of(clue.words.begin(), clue.words.end(), [](const std::string& word) {
    return (word.starts_with("dir") && !word.starts_with("direit")) || word.starts_with("ph");
  });
}

// The pins of one motor, with their functions.
class Motor {
 public:
  Motor(const Evidence& evidence, Pins pins) : clues_(evidence) {
    for (const PinEvidence* clue : pins) (is_pwm(evidence, *clue) ? pwm_ : level_).push_back(clue);
    if (pwm_.size() == 1 && level_.size() == 2) {
      en_ = pwm_[0];
      inputs(level_[0], level_[1]);
    } else if (pwm_.size() == 2 && level_.size() <= 1) {
      if (!level_.empty()) en_ = level_[0];
      inputs(pwm_[0], pwm_[1]);
    } else if (pwm_.size() == 1 && level_.size() == 1) {
      if (named_order(*pwm_[0], *level_[0]) != 0 && !is_direction(*level_[0]))
        inputs(pwm_[0], level_[0]);
      else
        phase();
    } else if (pwm_.empty() && level_.size() == 3) {
      std::stable_sort(level_.begin(), level_.end(), [](const PinEvidence* a, const PinEvidence* b) {
        return says(a->words, {"en", "pwm", "speed"}) > says(b->words, {"en", "pwm", "speed"});
      });
      en_ = level_[0];
      inputs(level_[1], level_[2]);
    } else if (pwm_.empty() && level_.size() == 2) {
      inputs(level_[0], level_[1]);
    } else if (pwm_.size() + level_.size() == 1) {
      en_ = pwm_.empty() ? level_[0] : pwm_[0];
    }
  }

  bool found() const { return en_ || in1_; }
  bool is_phase() const { return phase_ != nullptr; }
  bool is_transistor() const { return en_ && !in1_ && !phase_; }
  /// Returns whether the name of an input means forward or backward, also as an abbreviation.
  bool direction_is_named() const {
    if (!in1_ || are_letters(*in1_, *in2_)) return false;
    if (in1_->is_direction_from_source && in2_->is_direction_from_source) return false;
    return (is_forward(*in1_) || is_backward(*in1_) || is_forward(*in2_) || is_backward(*in2_));
  }

  const std::vector<PinBlock>& blocks() const { return clues_.names().blocks; }
  MotorPins motor_pins() const {
    const auto pin = [](const PinEvidence* clue) { return clue ? clue->pin : kNoPin; };
    return {pin(en_), pin(phase_ ? phase_ : in1_), pin(in2_)};
  }
  /// Returns 1 if the source sets in1 (or the phase) HIGH to drive forward, and -1 if it sets LOW. Returns 0
  /// if the source leaves this open.
  int forward_in_source() const { return forward_in_blocks(clues_.names().blocks, motor_pins()); }

  // Returns a value above 0 if the motor was mostly driven forward.
  double lean() const {
    const Pin enable = en_ ? en_->pin : kNoPin;
    if (phase_) return clues_.history().lean(enable, phase_->pin, kNoPin);
    return in1_ ? clues_.history().lean(enable, in1_->pin, in2_->pin) : 0.0;
  }

  /// Returns whether the run drove the motor backwards almost all the time. A robot that has lost the line
  /// turns both ways, which shows nothing.
  bool leans_back() const {
    constexpr double kMostly = 0.8;
    const MotorPins pins = motor_pins();
    return lean() < 0.0 && -lean() > kMostly * clues_.history().effort(pins.en, pins.in1, pins.in2);
  }

  std::string pins() const {
    std::string text;
    const auto add = [&](const char* use, const PinEvidence* clue) {
      if (clue) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", use, clues_.toml(clue->pin));
    };
    add("en", en_);
    add("phase", phase_);
    add("in1", in1_);
    add("in2", in2_);
    return "{ " + text + " }";
  }

  std::string why() const {
    std::string text;
    for (const PinEvidence* clue : {en_, phase_, in1_, in2_})
      if (clue && text.find(clue->name) == std::string::npos) text += (text.empty() ? "" : ", ") + clue->name;
    return text;
  }

 private:
  void inputs(const PinEvidence* a, const PinEvidence* b) {
    const int order = named_order(*a, *b);
    in1_ = order < 0 ? b : a;
    in2_ = order < 0 ? a : b;
    const int forward = direction_is_named() ? 1 : forward_in_source();
    if (forward < 0 || (forward == 0 && order == 0 && lean() < 0.0)) std::swap(in1_, in2_);
  }
  void phase() {
    en_ = pwm_[0];
    phase_ = level_[0];
  }

  const Evidence& clues_;
  Pins pwm_, level_;
  const PinEvidence* en_ = nullptr;
  const PinEvidence* phase_ = nullptr;
  const PinEvidence* in1_ = nullptr;
  const PinEvidence* in2_ = nullptr;
};

constexpr std::size_t kMostPinsOfAMotor = 3;

struct Sides {
  Pins left, right;
  bool named = true;
  bool paired = true;  ///< false: the assignment of direction pins to PWM pins is only guessed
};

// Returns the pins of one motor that the sketch passes to one object, as in Motor(5, 7, 8). `number` selects
// the object, counted from 0, if the sketch has several.
Pins given_together(const Evidence& evidence, const Pins& pins, std::size_t number) {
  for (const Given& given : evidence.names().given) {
    Pins group;
    for (const PinEvidence* clue : pins)
      if (std::count(given.pins.begin(), given.pins.end(), clue->pin) != 0) group.push_back(clue);
    const bool one =
        group.size() == given.pins.size() && group.size() >= 2 && group.size() <= kMostPinsOfAMotor;
    if (one && number-- == 0) return group;
  }
  return {};
}

void put_half(const Pins& pins, Sides& sides) {
  const std::size_t half = (pins.size() + 1) / 2;
  for (std::size_t i = 0; i < pins.size(); ++i) (i < half ? sides.left : sides.right).push_back(pins[i]);
}

// Reads six or four pins of one object, MotorPair(1, 2, 3, 4, 5, 6). The first half belongs to one motor, the
// second half to the other.
Sides given_as_pair(const Evidence& evidence, const Pins& pins) {
  for (const Given& given : evidence.names().given) {
    Sides sides{{}, {}, false};
    const std::size_t half = pins.size() / 2;
    for (const PinEvidence* clue : pins) {
      const auto at = std::find(given.pins.begin(), given.pins.end(), clue->pin) - given.pins.begin();
      (static_cast<std::size_t>(at) < half ? sides.left : sides.right).push_back(clue);
    }
    const bool all = std::all_of(pins.begin(), pins.end(), [&](const PinEvidence* clue) {
      return std::count(given.pins.begin(), given.pins.end(), clue->pin) != 0;
    });
    if (all && sides.left.size() == half && pins.size() == 2 * half) return sides;
  }
  return {};
}

Sides divide(const Evidence& evidence, const Pins& pins) {
  Sides sides;
  Pins unknown;
  for (const PinEvidence* clue : pins) {
    const Side side = side_of(clue->words);
    (side == Side::left ? sides.left : side == Side::right ? sides.right : unknown).push_back(clue);
  }
  if (!sides.left.empty() && !sides.right.empty() &&
      sides.left.size() + sides.right.size() > unknown.size()) {
    // Conventions, such as A for the left motor, are only a guess.
    sides.named = std::all_of(pins.begin(), pins.end(), [](const PinEvidence* clue) {
      return side_of(clue->words) == Side::unknown || spelled_side(clue->words) != Side::unknown;
    });
    return sides;
  }
  sides = {given_together(evidence, pins, 0), given_together(evidence, pins, 1), false};
  if (!sides.left.empty() && !sides.right.empty()) return sides;
  sides = given_as_pair(evidence, pins);
  if (!sides.left.empty()) return sides;
  sides = {{}, {}, false};
  Pins pwm, level;
  for (const PinEvidence* clue : pins) (is_pwm(evidence, *clue) ? pwm : level).push_back(clue);
  put_half(pwm, sides);
  put_half(level, sides);
  sides.paired = pwm.empty() || level.empty();
  return sides;
}

// Takes the driver's enable pin: one pin without PWM that stays high, in addition to four inputs with PWM.
void take_enable_without_name(Evidence& evidence, Pins& pins, RobotDraft& draft) {
  constexpr double kMostly = 0.45;  // the result of lean() is at most 0.5
  const auto is_level = [&](const PinEvidence* clue) { return !is_pwm(evidence, *clue); };
  if (pins.size() != 5 || std::count_if(pins.begin(), pins.end(), is_level) != 1) return;
  const auto enable = std::find_if(pins.begin(), pins.end(), is_level);
  if (!(*enable)->name.empty() || evidence.history().lean(kNoPin, (*enable)->pin, kNoPin) < kMostly) return;
  draft.standby = evidence.toml((*enable)->pin);
  evidence.take((*enable)->pin);
  pins.erase(enable);
}

// Adds the pin of the board's LED to three driven pins without names and PWM. Two motors have four such pins.
void add_led_pin(const Evidence& evidence, Pins& pins) {
  const PinEvidence& led = evidence.of(evidence.board().led_builtin);
  const auto has_name = [](const PinEvidence* clue) { return !clue->name.empty(); };
  const auto is_plain = [&](const PinEvidence* clue) { return !is_pwm(evidence, *clue); };
  if (std::count_if(pins.begin(), pins.end(), is_plain) == 3 &&
      std::none_of(pins.begin(), pins.end(), has_name) && led.name.empty() && led.facts->driven)
    pins.push_back(&led);
}

// Arduino's Motor Shield R3 (docs.arduino.cc/hardware/motor-shield-rev3): for each channel PWM, direction and
// brake.
constexpr const char* kShieldPins[2][3] = {{"D3", "D12", "D9"}, {"D11", "D13", "D8"}};

// Returns whether all pins belong to a Motor Shield R3, whose directions are at pins 12 and 13.
bool is_motor_shield(const Evidence& evidence, const Pins& pins) {
  const auto is_driven = [&](const char* name, bool with_pwm) {
    const Pin pin = find_pin(evidence.board(), name);
    if (pin == kNoPin) return false;
    const PinEvidence& clue = evidence.of(pin);
    return clue.facts->driven && is_pwm(evidence, clue) == with_pwm &&
           !says(clue.words, {"in", "ain", "bin", "pwma", "pwmb"});
  };
  const auto is_known = [&](const PinEvidence* clue) {
    for (const auto& channel : kShieldPins)
      for (const char* const name : channel)
        if (find_pin(evidence.board(), name) == clue->pin) return true;
    return false;
  };
  return is_driven("D3", true) && is_driven("D11", true) && is_driven("D12", false) &&
         is_driven("D13", false) && std::all_of(pins.begin(), pins.end(), is_known);
}

Sides sides_of_shield(Evidence& evidence, Pins& pins, RobotDraft& draft) {
  Sides sides;
  pins.clear();
  Side side_of_a = Side::unknown;
  for (int channel = 0; channel < 2; ++channel) {
    Pins& motor = channel == 0 ? sides.left : sides.right;
    for (int use = 0; use < 3; ++use) {
      const PinEvidence& clue = evidence.of(find_pin(evidence.board(), kShieldPins[channel][use]));
      const Side side = spelled_side(clue.words);
      if (channel == 0 && side != Side::unknown) side_of_a = side;
      if (use == 2 && clue.is_used()) {
        evidence.take(clue.pin);
        draft.questions.push_back(
            fmt::format("pin {} is the brake of channel {} of a Motor Shield R3: HIGH "
                        "brakes on the shield, but has no effect here",
                        evidence.toml(clue.pin), channel == 0 ? 'A' : 'B'));
      } else if (use < 2) {
        motor.push_back(&clue);
        pins.push_back(&clue);
      }
    }
  }
  if (side_of_a == Side::right) std::swap(sides.left, sides.right);
  sides.named = side_of_a != Side::unknown;
  return sides;
}

// Finds the pins of motors, and the standby pin of their driver.
Pins find_pins(Evidence& evidence, RobotDraft& draft, bool& has_standby) {
  Pins pins;
  for (const PinEvidence* clue : evidence.left()) {
    const bool is_standby =
        clue->facts->driven && says(clue->words, {"stby", "standby", "slp", "nsleep", "sleep"});
    has_standby |= is_standby;
    if (is_standby || is_enable_of_both(evidence, *clue)) {
      draft.standby = evidence.toml(clue->pin);
      evidence.take(clue->pin);
    } else if (is_of_serial(evidence.board(), clue->pin) &&
               !evidence.is_given_to({"digitalWrite", "analogWrite"}, clue->pin)) {
      continue;  // a mistake such as pinMode(leftSpeed, OUTPUT), where leftSpeed is a speed
    } else if (is_motor_like(*clue) && !(clue->name.empty() && clue->pin == evidence.board().led_builtin)) {
      pins.push_back(clue);
    }
  }
  take_enable_without_name(evidence, pins, draft);
  add_led_pin(evidence, pins);
  const auto has_name = [](const PinEvidence* clue) { return !clue->name.empty(); };
  if (std::count_if(pins.begin(), pins.end(), has_name) >= 2)
    pins.erase(std::stable_partition(pins.begin(), pins.end(), has_name), pins.end());
  return pins;
}

// If only conventions name the sides, corrects the sides by functions such as turnLeft(). If comments or
// values name the sides, and such functions contradict them, marks the sides as open.
void check_sides_in_source(const Evidence& evidence, Sides& sides) {
  const Motor left(evidence, sides.left), right(evidence, sides.right);
  const auto forward = [](const Motor& motor) {
    return motor.direction_is_named() ? 1 : motor.forward_in_source();
  };
  const int order = order_in_blocks(evidence.names().blocks, left.motor_pins(), right.motor_pins(),
                                    forward(left), forward(right));
  const bool is_from_source = std::any_of(sides.left.begin(), sides.left.end(),
                                          [](const PinEvidence* clue) { return clue->is_side_from_source; });
  if (is_from_source && order < 0) sides.named = false;
  if (sides.named || order == 0 || is_from_source) return;
  if (order < 0) std::swap(sides.left, sides.right);
  sides.named = true;
}

// Adds the part of one motor.
void add_motor(const Motor& motor, const Sides& sides, bool is_left, bool both_lean_back, const Ways& ways,
               RobotDraft& draft) {
  const int forward = motor.direction_is_named() ? 0 : motor.forward_in_source();
  const bool is_open = !motor.is_transistor() && !motor.direction_is_named() && forward == 0;
  (is_left ? draft.open.left_reversed : draft.open.right_reversed) = is_open;
  PartDraft part{is_left ? "left" : "right", "motor", {{"pins", motor.pins()}}, motor.why(), {}};
  if (!sides.named)
    part.doubts.push_back(
        "which motor is the left one is guessed: from A and B, numbers, or the order of the pins");
  if (!sides.paired)
    part.doubts.push_back("which inputs belong to which PWM pin is guessed from the order of the pins");
  // If the robot mostly turns on the spot, one motor runs backwards. The names are therefore wrong only if
  // both motors run backwards.
  const bool leans_back = is_open ? motor.leans_back() : forward == 0 && both_lean_back;
  const bool other_way = is_left ? ways.left_reversed : ways.right_reversed;
  if ((leans_back || forward < 0) != other_way) part.keys.emplace_back("reversed", "true");
  if (other_way) part.doubts.push_back(fmt::format("reversed or not: {}", kByTrial));
  if (leans_back && !other_way)
    part.doubts.push_back("reversed, because the sketch mostly drives it backwards");
  for (const PinBlock& block : motor.blocks())
    for (const PinWrite& write : block.writes)
      if (motor.is_transistor() && write.pin == motor.motor_pins().en && write.is_said_off &&
          write.level > 0 && part.notes.empty())
        part.notes.push_back("? a comment says that HIGH stops this motor: here, HIGH drives it");
  draft.parts.push_back(std::move(part));
}

}  // namespace

void guess_motors(Evidence& evidence, const Ways& ways, RobotDraft& draft) {
  if (std::any_of(draft.parts.begin(), draft.parts.end(),
                  [](const PartDraft& p) { return p.type == "motor"; }))
    return;  // the motors are on a shield
  bool has_standby = false;
  Pins pins = find_pins(evidence, draft, has_standby);
  if (pins.empty()) return;
  const bool is_shield = is_motor_shield(evidence, pins);
  Sides sides = is_shield ? sides_of_shield(evidence, pins, draft) : divide(evidence, pins);
  check_sides_in_source(evidence, sides);
  const Motor left(evidence, sides.left), right(evidence, sides.right);
  for (const auto* side : {&sides.left, &sides.right}) {
    if (side->size() <= kMostPinsOfAMotor) continue;
    draft.questions.push_back(
        fmt::format("{} pins are driven for the motors on one side: which of them belong to the same motor? "
                    "Motors in parallel count as one part",
                    side->size()));
  }
  if (!left.found() || !right.found() || left.is_transistor() != right.is_transistor()) return;
  draft.open.other_sides = !sides.named;
  const bool both_lean_back = left.lean() < 0.0 && right.lean() < 0.0;
  for (const bool is_left : {true, false})
    add_motor(is_left != ways.other_sides ? left : right, sides, is_left, both_lean_back, ways, draft);
  for (const auto* side : {&sides.left, &sides.right})
    for (const PinEvidence* clue : *side) evidence.take(clue->pin);
  const bool toshiba = has_standby || std::any_of(pins.begin(), pins.end(), [](const PinEvidence* clue) {
                         return says(clue->words, {"ain", "bin", "pwma", "pwmb"});
                       });
  draft.driver = left.is_transistor()            ? "transistor"
                 : left.is_phase() && !is_shield ? "drv8835"
                 : toshiba                       ? "tb6612"
                                                 : "l298n";
  draft.open.strong_driver = draft.driver == "l298n";
  if (ways.strong_driver) draft.driver = "tb6612";
}

}  // namespace robosim::wiring
