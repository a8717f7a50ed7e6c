#include "sim/run/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "sim/base/did_you_mean.h"
#include "sim/base/file_kind.h"
#include "sim/base/utf8.h"
#include "sim/run/scenario/script_line.h"

namespace robosim::scenario {
namespace {

constexpr std::array kVerbs = {"press", "release",  "send",  "place", "lift",  "lower",
                               "cover", "obstacle", "clear", "fault", "power", "sweep",
                               "tilt",  "paint",    "erase", "door",  "light"};

constexpr SimTime kSweep = 5 * kSecond, kSweepPeriod = kSecond;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr SimTime kTilt = 3 * kSecond, kTiltWay = 500 * kMillisecond;

constexpr std::uint64_t kMostEvents = 1'000'000'000'000;

Trigger parse_trigger(ScriptLine& line) {
  Trigger trigger;
  const std::string when = line.take("at or after").text;
  if (when == "at") {
    trigger.time = line.duration();
    return trigger;
  }
  if (when != "after")
    line.refuse(fmt::format("unknown trigger: expected `at TIME` or `after EVENT`, got “{}”{}", when,
                            did_you_mean(when, {"at", "after"})));
  const std::string event = line.take("an event: serial, station, boot, eeprom or a part").text;
  if (event == "serial") {
    trigger.kind = Trigger::Kind::serial;
    trigger.text = line.take("the text to wait for").text;
    if (trigger.text.empty()) line.refuse("the text to wait for is empty: expected at least one character");
  } else if (event == "station") {
    trigger.kind = Trigger::Kind::station;
    trigger.text = line.take("the station's number or name").text;
  } else if (event == "boot" || event == "eeprom") {
    trigger.kind = event == "boot" ? Trigger::Kind::boot : Trigger::Kind::eeprom;
    trigger.count =
        line.whole(event == "boot" ? "the number of a start" : "the number of a write", 1, kMostEvents);
  } else if (line.next_is_quoted()) {
    trigger.kind = Trigger::Kind::told;
    trigger.part = event;
    trigger.text = line.take("the text to wait for").text;
  } else {
    line.refuse(fmt::format(
        "unknown event: expected serial, station, boot, eeprom or a part with a text in quotes, got “{}”{}",
        event, did_you_mean(event, {"serial", "station", "boot", "eeprom"})));
  }
  if (line.take_if("wait")) trigger.time = line.duration();
  return trigger;
}

// Parses send "TEXT", or send PART MESSAGE [for TIME].
void parse_send(ScriptLine& line, Action& action) {
  const Word first = line.take("the text to send");
  if (first.quoted || !line.more()) {
    action.text = first.text;
    return;
  }
  action.part = first.text;
  action.text = line.take("what to send").text;
  action.held = line.optional_duration().value_or(0);
}

// Parses obstacle X,Y [radius LENGTH] [to X,Y in TIME] [for TIME]
void parse_obstacle(ScriptLine& line, Action& action) {
  action.text = line.take("a cell as X,Y").text;
  if (line.take_if("radius"))
    action.radius = line.quantity("a radius from 5mm to 500mm", Dimension::length, 0.005, 0.5);
  if (line.take_if("to")) {
    action.to = line.take("the cell that it moves to, as X,Y").text;
    if (!line.take_if("in")) line.refuse("the duration of the move is missing: expected `to X,Y in TIME`");
    action.period = line.duration();
    if (action.period < kTick) line.refuse("the move is too fast: expected at least 1ms after \"in\"");
  }
  action.duration = line.optional_duration();
}

// Parses paint X,Y X,Y [for TIME], or erase with the same arguments.
void parse_paint(ScriptLine& line, Action& action) {
  action.text = line.take("the cell where it begins, as X,Y").text;
  action.text += " " + line.take("the cell where it ends, as X,Y").text;
  action.duration = line.optional_duration();
}

/// Parses the state of an object, which is one of two words. `what` names the object.
void parse_state(ScriptLine& line, Action& action, const char* what, const char* one, const char* other) {
  action.part = line.take(fmt::format("{} or {}", one, other).c_str()).text;
  if (action.part != one && action.part != other)
    line.refuse(fmt::format("{}: {}", what, expected_one_of(action.part, {one, other})));
  action.duration = line.optional_duration();
}

// Parses door X,Y X,Y shut|open [for TIME]
void parse_door(ScriptLine& line, Action& action) {
  action.text = line.take("the cell at one end, as X,Y").text;
  action.text += " " + line.take("the cell at the other end, as X,Y").text;
  parse_state(line, action, "a door", "shut", "open");
}

// Parses light NUMBER|all on|off [for TIME]
void parse_light(ScriptLine& line, Action& action) {
  action.text = line.take("a light's number, or all").text;
  parse_state(line, action, "a light", "on", "off");
}

// Parses fault NAME KIND [ARGUMENT…] [for TIME]
void parse_fault(ScriptLine& line, Action& action) {
  action.part = line.take("a part's name").text;
  action.arguments.push_back(line.take("a kind of fault").text);
  while (line.more() && !line.next_is("for")) action.arguments.push_back(line.take("an argument").text);
  action.duration = line.optional_duration();
}

// Parses power off [for TIME] [byte old|new|erased|VALUE]
void parse_power(ScriptLine& line, Action& action) {
  action.part = line.take("off or on").text;
  if (action.part != "off" && action.part != "on")
    line.refuse(fmt::format("power: {}", expected_one_of(action.part, {"off", "on"})));
  if (action.part == "on") return;
  if (line.more() && !line.next_is("byte")) action.duration = line.optional_duration();
  if (!line.take_if("byte")) return;
  const std::string what = line.take("the byte's content: old, new, erased or a value").text;
  HalfWritten& byte = action.half_written;
  if (what == "new") return;
  byte.kind = what == "old" ? HalfWritten::Kind::before : HalfWritten::Kind::value;
  if (what == "old" || what == "erased") return;
  const std::uint64_t value = parse_unsigned(what).value_or(256);
  if (value > 255)
    line.refuse(
        fmt::format("the half-written byte: expected old, new, erased or a value from 0 to 255, got “{}”{}",
                    what, did_you_mean(what, {"old", "new", "erased"})));
  byte.value = static_cast<std::uint8_t>(value);
}

// Parses sweep LENGTH [every TIME] [for TIME]
void parse_sweep(ScriptLine& line, Action& action) {
  action.reach = line.quantity("the distance to each side, from 1mm to 500mm", Dimension::length, 0.001, 0.5);
  action.period = line.take_if("every") ? line.duration() : kSweepPeriod;
  if (action.period < kTick) line.refuse("the sweep is too fast: expected at least 1ms after \"every\"");
  action.duration = line.optional_duration().value_or(kSweep);
}

// Parses tilt ANGLE ahead|back|left|right [in TIME] [for TIME]
void parse_tilt(ScriptLine& line, Action& action) {
  action.angle = line.quantity("an angle from 1deg to 180deg", Dimension::angle, kDegree, 180 * kDegree);
  const std::string side = line.take("ahead, back, left or right").text;
  if (side == "ahead" || side == "back")
    action.side = {side == "ahead" ? 1.0 : -1.0, 0.0};
  else if (side == "left" || side == "right")
    action.side = {0.0, side == "left" ? 1.0 : -1.0};
  else
    line.refuse(
        fmt::format("the side of a tilt: {}", expected_one_of(side, {"ahead", "back", "left", "right"})));
  action.period = line.take_if("in") ? line.duration() : kTiltWay;
  action.duration = line.optional_duration().value_or(std::max(kTilt, 2 * action.period));
  if (action.period < kTick) line.refuse("the tilt is too fast: expected at least 1ms after \"in\"");
  if (*action.duration < 2 * action.period)
    line.refuse(
        "the duration is too short: a tilt goes there and back, each in the time after \"in\" (500ms if it "
        "is "
        "not given)");
}

Action parse_action(ScriptLine& line) {
  Action action;
  const std::string verb = line.take("a verb").text;
  std::size_t index = 0;
  while (index < kVerbs.size() && verb != kVerbs[index]) ++index;
  if (index == kVerbs.size())
    line.refuse(fmt::format("unknown verb: {}", expected_one_of(verb, {kVerbs.begin(), kVerbs.end()})));
  action.verb = static_cast<Action::Verb>(index);
  switch (action.verb) {
    case Action::Verb::press:
    case Action::Verb::cover:
      action.part = line.take("a part's name").text;
      action.duration = line.optional_duration();
      break;
    case Action::Verb::release:
      action.part = line.take("a part's name").text;
      break;
    case Action::Verb::send:
      parse_send(line, action);
      break;
    case Action::Verb::place:
      action.text = line.take("a place as X,Y,DIR").text;
      if (line.more()) action.text += "," + line.take("a direction").text;
      break;
    case Action::Verb::lift:
      action.duration = line.optional_duration();
      break;
    case Action::Verb::lower:
      break;
    case Action::Verb::obstacle:
      parse_obstacle(line, action);
      break;
    case Action::Verb::clear:
      action.text = line.take("a cell as X,Y").text;
      break;
    case Action::Verb::fault:
      parse_fault(line, action);
      break;
    case Action::Verb::power:
      parse_power(line, action);
      break;
    case Action::Verb::sweep:
      parse_sweep(line, action);
      break;
    case Action::Verb::tilt:
      parse_tilt(line, action);
      break;
    case Action::Verb::paint:
    case Action::Verb::erase:
      parse_paint(line, action);
      break;
    case Action::Verb::door:
      parse_door(line, action);
      break;
    case Action::Verb::light:
      parse_light(line, action);
      break;
  }
  line.end();
  return action;
}

std::optional<Step> parse_step(std::string_view text, const Place& place, const Share& share) {
  ScriptLine line(text, place, share);
  if (!line.more()) return std::nullopt;
  Step step;
  step.place = {place.file, place.line, 0};
  step.trigger = parse_trigger(line);
  step.action = parse_action(line);
  if (line.varies()) step.varies = text.substr(0, text.find_last_not_of(" \t\r") + 1);
  return step;
}

}  // namespace

std::optional<Step> parse_step(std::string_view text, const Place& place) {
  std::optional<Step> step = parse_step(text, place, [](std::size_t) { return 0.0; });
  if (step && !step->varies.empty())
    for (const double end : {-1.0, 1.0}) parse_step(text, place, [end](std::size_t) { return end; });
  return step;
}

std::string subject_of(const Action& action) {
  using enum Action::Verb;
  switch (action.verb) {
    case power:
      return "power";
    case fault:
      return "fault " + action.part;
    case obstacle:
    case clear:
      return "obstacle " + action.text;
    case lift:
    case lower:
    case place:
    case sweep:
    case tilt:
      return "body";
    case paint:
    case erase:
      return "floor " + action.text;
    case door:
      return "door " + action.text;
    case light:
      return "light " + action.text;
    default:
      return "";
  }
}

std::string finger_of(const Action& action) {
  using enum Action::Verb;
  return action.verb == press ? "press " + action.part : action.verb == cover ? "cover " + action.part : "";
}

Step parse_varied(const Step& step, const Share& share) {
  return *parse_step(step.varies, {step.place.file, step.place.line, 1}, share);
}

namespace {

std::vector<Step> parse_rows(std::string_view text, const std::string& file) {
  std::vector<Step> steps;
  int number = 0;
  text = without_byte_order_mark(text);
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    const std::string_view row = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (std::optional<Step> step = scenario::parse_step(row, {file, number, 1}))
      steps.push_back(std::move(*step));
  }
  return steps;
}

}  // namespace

std::vector<Step> parse_scenario(std::string_view text, const std::string& file) {
  return read_as(FileKind::script, text, file, [&] { return parse_rows(text, file); });
}

}  // namespace robosim::scenario
