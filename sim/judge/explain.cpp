#include "sim/judge/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "hal/board/firmware_action.h"
#include "sim/result/advice.h"

namespace robosim::judge {
namespace {

std::string seconds(SimTime t) { return fmt::format("{:.2f} s", static_cast<double>(t) * 1e-9); }

std::string cell_of(const map::Map& map, Vec2 p) {
  const int column = static_cast<int>(std::floor(p.x / map.cell_m));
  const int row = map.height - 1 - static_cast<int>(std::floor(p.y / map.cell_m));
  return fmt::format("column {}, row {}", column, row);
}

std::string place_of(const exec::SourceLine& where) {
  if (where.file.empty()) return "";
  std::string text = where.function.empty() ? " at " : fmt::format(" in {}, ", where.function);
  text += where.file;
  if (where.line > 0) text += fmt::format(":{}", where.line);
  return text;
}

// Returns a pin as sketches write it: "4", "A1".
std::string number_or_name(const Evidence& e, Pin pin) {
  const bool analog = e.board && pin < e.board->pin_count && e.board->pins[pin].name[0] == 'A';
  return analog ? e.board->pins[pin].name : std::to_string(pin);
}

std::string pin_name(const Evidence& e, Pin pin) {
  const std::string name = number_or_name(e, pin);
  for (const robot::WiredPin& wired : e.wiring)
    if (wired.pin == pin) return fmt::format("pin {} ({} \"{}\")", name, wired.type, wired.part);
  return fmt::format("pin {} (nothing is wired to it)", name);
}

bool is_at(const exec::Activity& a, std::string_view function) { return a.call.rfind(function, 0) == 0; }

// Returns the pin for which the sketch seems to wait: the only input that it has read lately. A sketch may
// follow the line with a single input. If the robot has moved or drives, the sketch therefore counts as
// waiting only in digitalRead() or pulseIn().
Pin awaited_pin(const Evidence& e) {
  if (is_at(e.activity, "pulseIn"))
    return e.t - e.activity.last_call < kSilentAfter ? e.activity.pin : kNoPin;
  const bool drives = e.left_command != 0.0 || e.right_command != 0.0;
  return is_at(e.activity, "digitalRead") || (!e.moved && !drives) ? e.activity.polled : kNoPin;
}

bool drives(const Evidence& e) { return e.moved && e.judge->drives(e.t); }

bool drives_long(const Evidence& e, const Judge::Stay& stay) {
  return drives(e) && e.t - e.judge->drives_since(stay) >= kInOnePlaceAfter;
}

// Returns the robot's mean turn rate, in rad/s, since it began to turn in one direction during a stay; above
// 0 = anticlockwise.
double turn_rate(const Evidence& e, const Judge::Stay& stay) {
  return e.judge->turned_during(stay) / (1e-9 * static_cast<double>(e.t - e.judge->turns_since(stay)));
}

// Returns whether a robot still turns in the direction in which it has turned during a stay. This excludes a
// robot that turned long ago, for example to calibrate its sensors.
bool still_turns(const Evidence& e, const Judge::Stay& stay) {
  constexpr double kSlowest = 0.5;  // rad/s, a turn in 12.6 s
  const double rate = turn_rate(e, stay);
  return std::abs(rate) >= kSlowest && (e.right_command - e.left_command) * rate > 0.0;
}

// Returns whether the robot circles. A robot whose sensors have seen the line during the last turn just
// follows a small loop.
bool circles(const Evidence& e) {
  constexpr double kTurn = kTwoTurns / 2.0;
  const Judge::Stay& stay = e.judge->surroundings();
  if (!drives_long(e, stay) || std::abs(e.judge->turned_during(stay)) < kThreeTurns || !still_turns(e, stay))
    return false;
  const auto& seen = e.judge->line_last_seen();
  return !seen || 1e-9 * static_cast<double>(e.t - seen->at) >= kTurn / std::abs(turn_rate(e, stay));
}

// Returns a clause on the sketch's activity, such as "; the sketch was last in …", for a run whose time is
// up.
std::string waiting(const Evidence& e) {
  if (!e.power.on) return "";
  const exec::Activity& a = e.activity;
  if (!a.stopped_by.empty()) return fmt::format("; the sketch stopped itself by {}", a.stopped_by);
  if (e.t - a.last_call >= kSilentAfter) {
    const std::string place = place_of(a.where);
    return fmt::format(
        "; the sketch has {} since {}{}{}",
        e.on_chip ? "used no pin, timer or interface, except in interrupts," : "called no Arduino function",
        seconds(a.last_call), place.empty() ? "" : ", and was last", place);
  }
  const Pin pin = awaited_pin(e);
  if (pin != kNoPin) {
    const bool by_call = is_at(a, "digitalRead"), by_pulse = is_at(a, "pulseIn");
    const std::string call = by_call    ? fmt::format(" with digitalRead({})", number_or_name(e, pin))
                             : by_pulse ? " with pulseIn()"
                                        : "";
    // The place where the sketch was last need not be the place where it reads the pin.
    const std::string place = place_of(a.where);
    return fmt::format("; the sketch keeps reading {}{}{}, and finds it {}{}", pin_name(e, pin), call,
                       by_pulse ? place : "", e.pin_level ? "HIGH" : "LOW",
                       by_call && !place.empty() ? "; it was last" + place : "");
  }
  if (drives_long(e, e.judge->place()) || circles(e)) return "";
  if (a.call.empty()) return a.where.file.empty() ? "" : "; the sketch was" + place_of(a.where);
  return fmt::format("; the sketch was last in {}{}", a.call, place_of(a.where));
}

// Returns a clause such as "left the line at 3.20 s near column 20, row 4", or "".
std::string left_line(const Evidence& e, SimTime t) {
  const auto& seen = e.judge->line_last_seen();
  if (!left_line_before(e, t)) return "";
  return fmt::format("left the line at {} near {}", seconds(seen->at), cell_of(*e.map, seen->position));
}

// Returns the robot's history for a run whose time is up: "; the robot left the line at …, and has stood near
// … since …".
std::string whereabouts(const Evidence& e) {
  const Judge::Stay& here = e.judge->place();
  const bool spin = spins(e), circle = !spin && circles(e);
  const Judge::Stay& stay = circle ? e.judge->surroundings() : here;
  const SimTime since = spin || circle ? e.judge->turns_since(stay)
                        : drives(e)    ? e.judge->drives_since(stay)
                                       : std::max(here.since, e.judge->last_driven());
  // A robot that spins or circles may see the line in each turn.
  std::string text = (spin || circle) && e.judge->line_last_seen() && e.judge->line_last_seen()->at > since
                         ? ""
                         : left_line(e, e.t);
  if (!e.moved || (!spin && !circle && e.t - since < kInOnePlaceAfter))
    return text.empty() ? "" : "; the robot " + text;
  const char* const direction = e.judge->turned_during(stay) > 0.0 ? "anticlockwise" : "clockwise";
  const std::string how = spin        ? fmt::format("has been spinning {} near", direction)
                          : circle    ? fmt::format("has been circling {} within 1 m of", direction)
                          : drives(e) ? "has stayed, with its motors driven, within 10 cm of"
                                      : "has stood near";
  return fmt::format("; the robot {}{}{} {} since {}", text, text.empty() ? "" : ", and ", how,
                     cell_of(*e.map, stay.place), seconds(since));
}

// Returns advice on a crash, or "". A pin function of the chip's core crashes only if its pin number is
// wrong. On a board with a 16-bit int, a failed check may be due to an overflow.
std::string advice(const Evidence& e) {
  const std::string& check = e.crash->check;
  if (check.empty() && !e.crash->calls.empty() && e.board)
    for (const char* const function : kPinFunctions)
      if (e.crash->calls.front().function == function)
        return fmt::format("{}() got a number that is not a pin of the {}", function, e.board->name);
  const bool is_int_too_large =
      (check == "add_overflow" || check == "sub_overflow" || check == "mul_overflow") &&
      e.crash->reason.find("does not fit an int,") != std::string::npos;
  if (e.int_bits > 16 || !is_int_too_large) return "";
  if (check != "mul_overflow")
    return "On the chip, an int has 16 bits: declare the variables as long, or limit the result, for "
           "example with constrain().";
  return "On the chip, an int has 16 bits: make one of the numbers long, as in 1000L * analogRead(A1).";
}

std::string list_of_pins(const std::vector<int>& pins) {
  std::string text;
  for (std::size_t i = 0; i < pins.size(); ++i)
    text += (i == 0 ? "" : i + 1 == pins.size() ? " and " : ", ") + std::to_string(pins[i]);
  return text;
}

// Returns a clause such as "S2 was stuck at 1023 by the script".
std::string told(const ScriptFault& fault) {
  using robot::Failure;
  const std::string value = fault.arguments.size() > 1 ? fault.arguments[1] : "";
  const auto happened = [&]() -> std::string {
    switch (fault.failure.value_or(Failure::ok)) {
      case Failure::stuck:
        return value.empty() ? "was stuck" : "was stuck at " + value;
      case Failure::pressed:
      case Failure::released:
        return fmt::format("was stuck {}", name_of(*fault.failure));
      case Failure::dead:
      case Failure::reversed:
        return fmt::format("was made {}", name_of(*fault.failure));
      case Failure::swapped:
        return "was swapped with " + value;
      default:
        return fmt::format("got the fault \"{}\"", fmt::join(fault.arguments, " "));
    }
  };
  return fmt::format("{} {} by the script", fault.part, happened());
}

// Returns the last script fault that was active at `t` or had just ended; null = none.
const ScriptFault* fault_at(const Evidence& e, SimTime t) {
  constexpr SimTime kAfterEffect = kSecond;
  const ScriptFault* last = nullptr;
  for (const ScriptFault& fault : e.faults)
    if (fault.began <= t && (fault.ended == kNever || fault.ended + kAfterEffect >= t)) last = &fault;
  return last;
}

// Returns a phrase such as ", 0.30 s after S2 was stuck at 1023 by the script"; empty if there was no fault.
std::string after_fault(const Evidence& e, SimTime t) {
  const ScriptFault* fault = fault_at(e, t);
  return fault ? fmt::format(", {} after {}", seconds(t - fault->began), told(*fault)) : "";
}

// Returns a clause such as "; the board has had no power since 7.28 s: its battery is empty". Returns "" if
// the supply does not explain the verdict.
std::string for_want_of_power(const Evidence& e) {
  const bool ran_down = e.power.charge && (e.power.empty() || (!e.power.on && e.power.switched_on));
  const bool may_come_of_it = e.verdict == Verdict::lost || e.verdict == Verdict::stuck ||
                              e.verdict == Verdict::timeout ||
                              (e.verdict == Verdict::reached && ran_down && e.goal->kind == Goal::Kind::none);
  const std::string text = may_come_of_it ? told(e.power) : "";
  return text.empty() ? "" : "; " + text;
}

// Returns clauses with further causes, to append to a sentence.
std::string causes(const Evidence& e) {
  const std::string power = for_want_of_power(e);
  if (e.verdict == Verdict::lost || e.verdict == Verdict::reached) return power;
  const ScriptFault* fault = fault_at(e, e.t);
  if (!power.empty() && !e.power.on && fault && fault->part == "power" && !e.power.charge)
    return power + ": " + told(*fault);
  return power + after_fault(e, e.t);
}

std::string sentence(const Evidence& e);

std::string but_collided(const Evidence& e) {
  if (e.collisions == 0) return "";
  return fmt::format(", but with {} collision{}", e.collisions, e.collisions == 1 ? "" : "s");
}

/// Returns the remark that the robot was off the line; empty unless was_off_line().
std::string but_off_line(const Evidence& e) {
  if (!was_off_line(e)) return "";
  const std::optional<Judge::Seen>& left = e.judge->line_first_left();
  return fmt::format(
      ", but the robot was off the line for {}{}", seconds(e.off_line),
      left ? fmt::format(", first from {} near {}", seconds(left->at), cell_of(*e.map, left->position)) : "");
}

}  // namespace

bool was_off_line(const Evidence& e) {
  constexpr int kLeastShare = 4;  // a quarter of the time; gaps take less
  return e.verdict == Verdict::reached && e.goal->kind == Goal::Kind::laps && kLeastShare * e.off_line >= e.t;
}

bool spins(const Evidence& e) {
  const Judge::Stay& stay = e.judge->place();
  return drives_long(e, stay) && std::abs(e.judge->turned_during(stay)) >= kTwoTurns && still_turns(e, stay);
}

bool left_line_before(const Evidence& e, SimTime t) {
  constexpr double kSomewhereElse = 0.01;  // m
  const auto& seen = e.judge->line_last_seen();
  return e.moved && seen && t - seen->at >= kLeftLine && length(e.at - seen->position) >= kSomewhereElse;
}

std::string explain(const Evidence& e) {
  std::string text = sentence(e);
  if (text.empty()) return text;
  text.pop_back();
  return text + causes(e) + ".";
}

namespace {

std::string sentence(const Evidence& e) {
  const std::string done = e.progress->summary();
  const std::string undone =
      e.goal->kind == Goal::Kind::none ? std::string() : fmt::format(", before the goal: {}", done);
  switch (e.verdict) {
    case Verdict::reached:
      if (e.goal->kind == Goal::Kind::none)
        return fmt::format("{} of simulated time went by without a failure{}.", seconds(e.t),
                           but_collided(e));
      return fmt::format("The goal {} was reached after {}: {}{}.", to_string(*e.goal), seconds(e.t), done,
                         but_off_line(e));
    case Verdict::lost: {
      const auto& seen = e.judge->line_last_seen();
      if (!seen)
        return fmt::format(
            "The robot lost the line: its wheels have turned 1 m, and no line was under or between its "
            "sensors ({}).",
            done);
      return fmt::format(
          "The robot lost the line: its wheels have turned 1 m since the line was last under or between its "
          "sensors, at {} near {}{} ({}).",
          seconds(seen->at), cell_of(*e.map, seen->position), after_fault(e, seen->at), done);
    }
    case Verdict::stuck: {
      const std::string left = left_line(e, e.judge->stuck_since());
      if (e.judge->pushes())
        return fmt::format(
            "The robot {}is stuck: for 5 s it has pushed against {}, and has moved less than 10 cm ({}).",
            left.empty() ? "" : left + ", and ", e.stopped_by, done);
      return fmt::format(
          "The robot {}is stuck: for 3 s its motors were driven, but it neither moved 1 mm nor turned 1 "
          "degree{} ({}).",
          left.empty() ? "" : left + ", and ", e.in_contact ? "; it touches " + e.stopped_by : "", done);
    }
    case Verdict::toppled:
      return fmt::format("The robot {} near {} ({}).",
                         e.toppled == world::Toppled::off_an_edge ? "fell off an edge" : "tipped over",
                         cell_of(*e.map, e.at), done);
    case Verdict::hung:
      if (!e.activity.stopped_by.empty())
        return fmt::format("The sketch stopped itself by {}{} while the motors were running ({}).",
                           e.activity.stopped_by, place_of(e.activity.where), done);
      return fmt::format(
          "The sketch hangs{}: for 2 s it called no Arduino function while the motors were running ({}).",
          place_of(e.activity.where), done);
    case Verdict::ended:
      if (!e.activity.stopped_by.empty())
        return fmt::format("The sketch stopped itself by {}{} with the motors off{}.", e.activity.stopped_by,
                           place_of(e.activity.where), undone);
      return fmt::format(
          "The sketch ended{}: for 2 s it called no Arduino function, with the motors off{}{}.",
          place_of(e.activity.where), undone, whereabouts(e));
    case Verdict::crashed:
      return fmt::format(
          "{}: {}{}.",
          e.crash && !e.crash->check.empty() ? "A check (--sanitize) failed" : "The sketch crashed",
          e.crash ? e.crash->reason : "for an unknown reason", e.crash ? place_of(e.crash->where) : "");
    case Verdict::timeout:
      return fmt::format("The {} of simulated time are up before the goal {}: {}{}{}.", seconds(e.limit),
                         to_string(*e.goal), done, whereabouts(e), waiting(e));
    case Verdict::over_budget:
      return fmt::format("The sketch is over its budget: {} ({}).", e.exceeded, done);
    case Verdict::interrupted:
      return fmt::format("Interrupted after {} of simulated time ({}).", seconds(e.t), done);
  }
  return "";
}

}  // namespace

namespace {

bool turns_wheel(const robot::WiredPin& wired) {
  return wired.type == "motor" || wired.type == "motors" || wired.type == "wheel-servo";
}

// Returns whether a motor's pin may stay low. A phase pin may, and so may an input whose counterpart was
// high, because the motor may turn in one direction only.
bool may_stay_low(const robot::WiredPin& wired, const Evidence& e) {
  if (wired.role == "phase") return true;
  if (wired.role != "in1" && wired.role != "in2") return false;
  return std::any_of(e.wiring.begin(), e.wiring.end(), [&](const robot::WiredPin& other) {
    return other.part == wired.part && other.role != wired.role && other.role.rfind("in", 0) == 0 &&
           static_cast<std::size_t>(other.pin) < e.went_high.size() && e.went_high[other.pin];
  });
}

// Returns a reason if both inputs of a motor were high: equal levels brake a motor.
const char* equal_inputs(const std::vector<robot::WiredPin>& motor_pins, const Evidence& e) {
  const auto was_high = [&](const robot::WiredPin& wired, const char* role) {
    const auto pin = static_cast<std::size_t>(wired.pin);
    return wired.role == role && pin < e.went_high.size() && e.went_high[pin];
  };
  for (const robot::WiredPin& one : motor_pins)
    for (const robot::WiredPin& two : motor_pins)
      if (one.part == two.part && was_high(one, "in1") && was_high(two, "in2"))
        return ": with equal levels at both inputs, a driver brakes its motor";
  return "";
}

// Returns clauses on the motor pins that were never HIGH, such as "; motor pins 5 and 7 stayed LOW". Returns
// "" if there are no such pins.
std::string quiet_pins(const std::vector<robot::WiredPin>& motor_pins, const Evidence& e) {
  std::vector<int> low, never_output;
  for (const robot::WiredPin& wired : motor_pins) {
    const auto pin = static_cast<std::size_t>(wired.pin);
    if (pin >= e.went_high.size() || e.went_high[pin] || may_stay_low(wired, e)) continue;
    auto& list = e.was_output[pin] ? low : never_output;
    if (std::find(list.begin(), list.end(), wired.pin) == list.end()) list.push_back(wired.pin);
  }
  std::string text;
  if (!low.empty())
    text += fmt::format("; motor pin{} {} stayed LOW", low.size() > 1 ? "s" : "", list_of_pins(low));
  if (!never_output.empty())
    text +=
        fmt::format("; motor pin{} {}: no pinMode(…, OUTPUT) or analogWrite() has run for {}",
                    never_output.size() > 1 ? "s" : "",
                    list_of_pins(never_output) + (never_output.size() > 1 ? " are inputs" : " is an input"),
                    never_output.size() > 1 ? "them" : "it");
  return text;
}

// Returns the pins that drive a wheel; -1 = either wheel.
std::vector<robot::WiredPin> motor_pins(const Evidence& e, int wheel = -1) {
  std::vector<robot::WiredPin> pins;
  std::copy_if(e.wiring.begin(), e.wiring.end(), std::back_inserter(pins), [&](const robot::WiredPin& wired) {
    return turns_wheel(wired) && (wheel < 0 || wired.wheel == wheel);
  });
  return pins;
}

// Returns a text if one wheel never got power, although the other wheel did.
std::string unpowered_side(const Evidence& e) {
  constexpr double kClearly = 0.1;
  for (const world::Side side : {world::left, world::right}) {
    const world::Side other = side == world::left ? world::right : world::left;
    if (e.strongest_command[side] > robot::kSmallestPulse || e.strongest_command[other] < kClearly) continue;
    const std::vector<robot::WiredPin> pins = motor_pins(e, side);
    std::string text = fmt::format("the {} motor never got power", side == world::left ? "left" : "right");
    const std::string quiet = quiet_pins(pins, e);
    return text + (quiet.empty() ? equal_inputs(pins, e) : quiet);
  }
  return "";
}

// Returns a text if the motor driver's standby pin was never HIGH, so that the driver's motors stay off.
std::string sleeping_driver(const Evidence& e) {
  const auto is_high = [&](const robot::WiredPin& wired) {
    return turns_wheel(wired) && static_cast<std::size_t>(wired.pin) < e.went_high.size() &&
           e.went_high[wired.pin];
  };
  // If no motor pin was ever HIGH, the standby pin may not be the reason: the sketch may wait at its
  // beginning.
  if (std::none_of(e.wiring.begin(), e.wiring.end(), is_high)) return "";
  for (const robot::WiredPin& wired : e.wiring) {
    const auto pin = static_cast<std::size_t>(wired.pin);
    if (wired.role != "standby" || pin >= e.went_high.size() || e.went_high[pin]) continue;
    return fmt::format(
        "the robot never moved: the standby pin {} of its motor driver {}, and the driver is off "
        "until this pin is HIGH",
        number_or_name(e, wired.pin), e.was_output[pin] ? "stayed LOW" : "was never set to OUTPUT");
  }
  return "";
}

// Returns a clause such as "motor pins 7 and 9 were never set to OUTPUT, and only their pull-ups were on".
// Returns "" if there are no such pins. Writing HIGH to an input enables its pull-up, which is enough to
// switch on some motor drivers.
std::string forgotten_outputs(const Evidence& e) {
  std::vector<int> pins;
  for (const robot::WiredPin& wired : e.wiring) {
    const auto pin = static_cast<std::size_t>(wired.pin);
    if (turns_wheel(wired) && pin < e.was_pulled_up.size() && e.was_pulled_up[pin] && !e.was_output[pin] &&
        std::find(pins.begin(), pins.end(), wired.pin) == pins.end())
      pins.push_back(wired.pin);
  }
  if (pins.empty()) return "";
  const bool many = pins.size() > 1;
  return fmt::format(
      "motor pin{} {} {} never set to OUTPUT, and only {} on, as by digitalWrite({}, HIGH): pinMode({}, "
      "OUTPUT)",
      many ? "s" : "", list_of_pins(pins), many ? "were" : "was",
      many ? "their pull-ups were" : "its pull-up was", pins[0], pins[0]);
}

// Returns when the robot stopped: the run's end, or earlier if the robot is stuck.
SimTime stopped_at(const Evidence& e) { return e.verdict == Verdict::stuck ? e.judge->stuck_since() : e.t; }

// Returns the robot's mean speed until it stopped, m/s.
double mean_speed(const Evidence& e) {
  const SimTime until = stopped_at(e);
  return until > 0 ? e.distance_m / (1e-9 * static_cast<double>(until)) : 0.0;
}

bool has_left_line(const Evidence& e) {
  const bool may_have_left = e.verdict == Verdict::stuck || e.verdict == Verdict::timeout;
  return e.verdict == Verdict::lost || (may_have_left && left_line_before(e, stopped_at(e)));
}

// Returns N if the sketch is in a delay(N) long enough to lose a line: at its mean speed, the robot drives 5
// cm or more. Otherwise, returns 0.
std::uint32_t long_delay(const Evidence& e) {
  constexpr double kLong_m = 0.05;
  std::uint32_t ms = 0;
  if (std::sscanf(e.activity.call.c_str(), "delay(%10" SCNu32 ")", &ms) != 1) return 0;
  return mean_speed(e) * ms * 1e-3 >= kLong_m ? ms : 0;
}

// Returns whether motors are driven, although no floor sensor has been read for 50 ms. A delay alone does not
// show this, because an interrupt handler may read sensors during the delay.
bool is_driven_blindly(const Evidence& e) {
  constexpr SimTime kJustNow = 50 * kMillisecond;
  const bool has_power = e.left_command != 0.0 || e.right_command != 0.0;
  return e.moved && has_power && (e.sensors_read == kNever || e.t - e.sensors_read >= kJustNow);
}

// Returns whether the sketch stopped reading its sensors at least half a second before the robot lost the
// line.
bool reads_no_more(const Evidence& e) {
  constexpr SimTime kLong = kSecond / 2;
  const auto& seen = e.judge->line_last_seen();
  return e.moved && has_left_line(e) && seen && e.sensors_read != kNever && e.sensors_read + kLong < seen->at;
}

// A robot that has followed the line for this distance is probably wired correctly.
constexpr double kFollowed_m = 1.0;

// Estimates from the mean speed how far the robot had driven when a sensor last saw the line.
double driven_until_lost(const Evidence& e) {
  const auto& seen = e.judge->line_last_seen();
  return seen ? mean_speed(e) * 1e-9 * static_cast<double>(std::min(seen->at, stopped_at(e))) : 0.0;
}

// Returns whether the robot steered away from the line before losing it, in a run without script faults.
bool steered_away(const Evidence& e) {
  constexpr double kClearly = 0.1;
  return e.moved && e.faults.empty() && e.steered < -kClearly && has_left_line(e) && !spins(e) && !circles(e);
}

}  // namespace

NextStep next_step(const Evidence& e) {
  if (was_off_line(e)) return {result::kWatch, NextStep::By::watching};
  if (e.verdict == Verdict::reached || e.verdict == Verdict::interrupted) return {};
  if (e.power.empty() && (e.verdict == Verdict::stuck || e.verdict == Verdict::timeout))
    return {"capacity_mAh and charge, in [battery] of the robot file, determine how long its battery lasts"};
  if (e.verdict == Verdict::crashed) return {e.crash ? advice(e) : ""};
  if (!e.divisions_by_zero.empty())
    return {fmt::format("the sketch divided by zero{}: the result is meaningless, so look at what uses it",
                        place_of(e.divisions_by_zero.front().where))};
  if (e.moved)
    if (const std::string forgotten = forgotten_outputs(e); !forgotten.empty()) return {forgotten};
  if (e.verdict == Verdict::lost || e.verdict == Verdict::stuck || e.verdict == Verdict::timeout)
    if (const std::string unpowered = unpowered_side(e); !unpowered.empty()) {
      // A number that exceeds a narrow int can hold a motor's power at 0.
      if (e.verdict == Verdict::lost && e.int_bits == 16)
        return {unpowered + result::kAlso + result::kTryHost, NextStep::By::host};
      return {unpowered};
    }
  if (reads_no_more(e))
    return {
        fmt::format("the sketch has read no line sensor since {}: it must read them repeatedly, in loop()",
                    seconds(e.sensors_read))};
  if (is_driven_blindly(e) && long_delay(e) > 0 && has_left_line(e))
    return {
        fmt::format("the sketch is in delay({}){}: during this time it reads no sensor, but the robot drives "
                    "on",
                    long_delay(e), place_of(e.activity.where))};
  if (steered_away(e)) {
    const std::string how =
        fmt::format("it steered away from the line: the line was under its {} sensors, but it turned {}; ",
                    e.line_side > 0.0 ? "left" : "right", e.line_side > 0.0 ? "right" : "left");
    if (const double before = driven_until_lost(e); before >= kFollowed_m)
      return {fmt::format("{}it had driven {:.1f} m until then: {}", how, before, result::kWatch),
              NextStep::By::watching};
    if (e.int_bits == 16)
      return {how + result::kTryHost + result::kIfNot + result::kTryWirings, NextStep::By::host};
    return {how + result::kTryWirings};
  }
  if (e.moved) {
    if (e.verdict == Verdict::lost && e.int_bits == 16) return {result::kTryHost, NextStep::By::host};
    if (e.verdict == Verdict::lost) return {result::kWatch, NextStep::By::watching};
    return {};
  }
  const double most = std::max(std::abs(e.left_command), std::abs(e.right_command));
  if (most > 0.0 && most < e.turning_drive)
    return {fmt::format(
        "the robot never moved: its motors are driven with {:.0f} % and {:.0f} % of full power, which is too "
        "little to turn the wheels; they turn from {:.0f} % on",
        100.0 * std::abs(e.left_command), 100.0 * std::abs(e.right_command),
        std::ceil(100.0 * e.turning_drive))};
  if (most > 0.0) return {};  // something else holds the wheels, such as a fault of the script
  if (const std::string driver = sleeping_driver(e); !driver.empty()) return {driver};
  const std::vector<robot::WiredPin> pins = motor_pins(e);
  const std::string quiet = quiet_pins(pins, e);
  std::string text = "the robot never moved" + quiet;
  if (pins.empty())
    text += ": it has no motors";
  else if (quiet.empty() && e.judge->last_driven() >= 0)
    text += "; its motors were driven, but not strongly or long enough to turn the wheels";
  else if (quiet.empty())
    text += std::string("; its motors were never driven") + equal_inputs(pins, e);
  const Pin pin = awaited_pin(e);
  if (pin == kNoPin) return {text};
  text += fmt::format("; the pin that the sketch keeps reading is {}, which is {}", pin_name(e, pin),
                      e.pin_level ? "HIGH" : "LOW");
  for (const robot::WiredPin& wired : e.wiring) {
    if (wired.pin == pin && wired.type == "button" && !e.pin_changed)
      return {text + fmt::format(
                         ": if it waits for this button, press it with this line in a script: at 1s press {} "
                         "200ms",
                         wired.part),
              NextStep::By::script};
  }
  return {text};
}

}  // namespace robosim::judge
