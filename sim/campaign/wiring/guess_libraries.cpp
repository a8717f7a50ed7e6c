#include <fmt/format.h>

#include <algorithm>

#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {
namespace {

std::string pins_table(const Evidence& evidence, const std::vector<std::pair<const char*, Pin>>& uses) {
  std::string text;
  for (const auto& [use, pin] : uses)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", use, evidence.toml(pin));
  return "{ " + text + " }";
}

bool all_free(const Evidence& evidence, const std::vector<std::pair<const char*, Pin>>& uses) {
  return std::all_of(uses.begin(), uses.end(), [&](const auto& use) { return evidence.is_free(use.second); });
}

class Libraries {
 public:
  Libraries(Evidence& evidence, RobotDraft& draft) : clues_(evidence), draft_(draft) {}

  void look(const Given& given) {
    const auto pin = [&](std::size_t i) { return i < given.pins.size() ? given.pins[i] : kNoPin; };
    const std::string& type = given.type;
    if (type == "attach" && clues_.is_free(pin(0))) {
      one_pin(given, "servo", pin(0));
    } else if (type == "NewPing" || type == "Ultrasonic" || type == "HCSR04" ||
               type == "UltraSonicDistanceSensor") {
      if (pin(0) == pin(1) || pin(1) == kNoPin)
        part(given, "hc-sr04", {{"sig", pin(0)}});
      else
        part(given, "hc-sr04", {{"trig", pin(0)}, {"echo", pin(1)}});
    } else if (type == "SoftwareSerial") {
      // Uses the labels on the module: txd is connected to the pin on which the sketch receives.
      part(given, "bluetooth", {{"txd", pin(0)}, {"rxd", pin(1)}});
      doubt("baud: the baud rate in " + given.name + ".begin(), if it is not 9600");
    } else if (type == "LiquidCrystal" && given.pins.size() == 6) {
      part(given, "lcd",
           {{"rs", pin(0)}, {"en", pin(1)}, {"d4", pin(2)}, {"d5", pin(3)}, {"d6", pin(4)}, {"d7", pin(5)}});
    } else if (type == "Encoder") {
      encoder(given, pin(0), pin(1));
    } else if (type == "Keypad" && given.each.size() >= 3) {
      keypad(given);
    } else if (type == "shiftOut" && given.each.size() == 2) {
      shift_register(given, pin(0), pin(1));
    } else if ((type == "IRrecv" || (type == "begin" && given.name == "IrReceiver")) &&
               clues_.is_free(pin(0))) {
      one_pin(given, "ir-receiver", pin(0));
    } else if (type == "Adafruit_NeoPixel" && clues_.is_free(pin(1))) {
      one_pin(given, "ws2812", pin(1));
      draft_.parts.back().keys.emplace_back(
          "leds",
          given.arguments[0].find_first_not_of("0123456789") == std::string::npos ? given.arguments[0] : "8");
    } else if (type == "pulseIn" && clues_.is_free(pin(0))) {
      echo(given, pin(0));
    }
  }

 private:
  void add(const Given& given, const std::string& type, std::pair<std::string, std::string> pins) {
    const bool has_name =
        !given.name.empty() && std::isalnum(static_cast<unsigned char>(given.name.front())) != 0;
    const std::string wanted = has_name ? given.name : type;
    draft_.parts.push_back({part_name(draft_, wanted),
                            type,
                            {std::move(pins)},
                            fmt::format("{}, {}:{}", given.type, given.spot.file, given.spot.line),
                            {}});
  }

  void part(const Given& given, const char* type, const std::vector<std::pair<const char*, Pin>>& uses) {
    found_ = all_free(clues_, uses);
    if (!found_) return;
    add(given, type, {"pins", pins_table(clues_, uses)});
    for (const auto& use : uses) clues_.take(use.second);
  }

  void one_pin(const Given& given, const char* type, Pin pin) {
    found_ = true;
    add(given, type, {"pin", clues_.toml(pin)});
    clues_.take(pin);
  }

  void doubt(std::string sentence) {
    if (found_) draft_.parts.back().doubts.push_back(std::move(sentence));
  }

  void encoder(const Given& given, Pin a, Pin b) {
    part(given, "encoder", {{"a", a}, {"b", b}});
    if (!found_) return;
    PartDraft encoder = std::move(draft_.parts.back());
    draft_.parts.pop_back();
    add_wheel_and_periods(draft_, side_of(words_of(given.name)), encoder);
    draft_.parts.push_back(std::move(encoder));
  }

  std::string list(const std::vector<Pin>& pins) const {
    std::string text;
    for (const Pin pin : pins) text += (text.empty() ? "" : ", ") + clues_.toml(pin);
    return "[" + text + "]";
  }

  // Reads Keypad(makeKeymap(keys), rowPins, colPins, ROWS, COLS).
  void keypad(const Given& given) {
    const std::vector<Pin>&rows = given.each[1], &columns = given.each[2];
    if (rows.empty() || columns.empty() || rows.size() > 8 || columns.size() > 8) return;
    for (const auto* pins : {&rows, &columns})
      for (const Pin pin : *pins)
        if (!clues_.is_free(pin)) return;
    add(given, "keypad", {"rows", list(rows)});
    draft_.parts.back().keys.emplace_back("columns", list(columns));
    draft_.parts.back().doubts.push_back(
        "keys: the labels of the keys, if they differ from the usual keypads");
    for (const auto* pins : {&rows, &columns})
      for (const Pin pin : *pins) clues_.take(pin);
  }

  // Returns whether a block that calls shiftOut() writes only this pin, which is then the latch.
  bool frames(Pin pin) const {
    for (const PinBlock& block : clues_.names().blocks) {
      const bool is_alone = std::all_of(block.writes.begin(), block.writes.end(),
                                        [&](const PinWrite& write) { return write.pin == pin; });
      if (block.shifts_out && is_alone) return true;
    }
    return false;
  }

  // Reads shiftOut(data, clock, …), and finds the latch by its name or by its writes.
  void shift_register(const Given& given, Pin data, Pin clock) {
    if (!clues_.is_free(data) || !clues_.is_free(clock)) return;
    Pin latch = kNoPin;
    for (const PinEvidence* clue : clues_.left())
      if (clue->facts->driven && clue->pin != data && clue->pin != clock && latch == kNoPin &&
          !says(clue->words, {"stby", "standby"}) &&
          (frames(clue->pin) ||
           says(clue->words, {"latch", "rclk", "rck", "st", "stcp", "strobe", "load", "cs", "ss"})))
        latch = clue->pin;
    if (latch == kNoPin) return;
    add(given, "shift-register",
        {"pins", pins_table(clues_, {{"data", data}, {"clock", clock}, {"latch", latch}})});
    draft_.parts.back().name = part_name(draft_, "REG");
    for (const Pin pin : {data, clock, latch}) clues_.take(pin);
    draft_.questions.push_back(
        "what is connected to the outputs of REG? Other parts use them as pins: \"REG.Q0\" to \"REG.Q7\"");
  }

  // Reads pulseIn() on a pin. The trigger is the pin with short pulses.
  void echo(const Given& given, Pin pin) {
    const auto is_named_echo = [&](Pin one) { return says(clues_.of(one).words, {"echo"}); };
    // Colour sensors are read with pulseIn(), too.
    if (!is_named_echo(pin))
      for (const Given& other : clues_.names().given)
        if (other.type == "pulseIn" && other.pins[0] != kNoPin && is_named_echo(other.pins[0])) return;
    // With several sensors, the names of a pair share a word: trigLeft and echoLeft.
    const std::vector<std::string>& words = clues_.of(pin).words;
    Pin trigger = kNoPin;
    std::ptrdiff_t most = -1;
    for (const PinEvidence* clue : clues_.left()) {
      if (clue->pin == pin || !clue->facts->driven || clue->facts->discharged) continue;
      const bool is_named = says(clue->words, {"trig", "ping"});
      if (!is_named && !clue->facts->pulses) continue;
      const std::ptrdiff_t shared =
          is_named ? 1 + std::count_if(clue->words.begin(), clue->words.end(),
                                       [&](const std::string& word) {
                                         return std::find(words.begin(), words.end(), word) != words.end();
                                       })
                   : 0;
      if (shared <= most) continue;
      most = shared;
      trigger = clue->pin;
    }
    if (trigger == kNoPin) return;
    part(given, "hc-sr04", {{"trig", trigger}, {"echo", pin}});
  }

  Evidence& clues_;
  RobotDraft& draft_;
  bool found_ = false;
};

}  // namespace

void guess_by_libraries(Evidence& evidence, RobotDraft& draft) {
  Libraries libraries(evidence, draft);
  for (const Given& given : evidence.names().given) libraries.look(given);
}

}  // namespace robosim::wiring
