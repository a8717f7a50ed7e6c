#include "sim/detect/doubtful_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace robosim::detect {
namespace {

constexpr SimTime kSetUp = 10 * kMillisecond;  // the longest time in which a sketch sets up a timer
constexpr int kHighest = 255, kNoInterrupt = 255;
constexpr std::size_t kMost = 16;
constexpr double kMsPerDay = 24 * 3600 * 1000;

/// Returns a pin's usual name: 5 for D5, or A0.
std::string name_of(const BoardSpec& board, Pin pin) {
  return board.pins[pin].name[0] == 'A' ? board.pins[pin].name : fmt::format("{}", pin);
}

bool is_avr(const BoardSpec& board) { return std::string_view(board.chip->target) == "avr"; }

/// Returns the pins for which `is_one` returns true, as "3, 5 and 6" if `last` is " and ".
template <class IsOne>
std::string pins_of(const BoardSpec& board, std::string_view last, IsOne&& is_one) {
  std::string names, held_back;
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    if (!is_one(board.pins[pin])) continue;
    if (!held_back.empty()) names += (names.empty() ? "" : ", ") + held_back;
    held_back = name_of(board, pin);
  }
  return names.empty() ? held_back : fmt::format("{}{}{}", names, last, held_back);
}

std::string pwm_pins(const BoardSpec& board) {
  return pins_of(board, ", ", [](const PinSpec& pin) { return pin.pwm; });
}

std::string place_of(const exec::SourceLine& where) {
  if (where.file.empty()) return "";
  const std::string line = fmt::format("{}:{}", where.file, where.line);
  return where.function.empty() ? " in " + line : fmt::format(" in {}, {}", where.function, line);
}

/// Returns the key of a timer's finding. The key differs from all pins and other arguments.
int64_t key_of(int64_t timer) { return -1 - timer; }

double seconds(SimTime t) { return 1e-9 * static_cast<double>(t); }

}  // namespace

bool DoubtfulActions::add_occurrence(const char* detector, int64_t key) {
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (keys_[i].argument != key || std::string_view(keys_[i].detector) != detector) continue;
    ++found_[i].times;
    return true;
  }
  return found_.size() >= kMost;
}

void DoubtfulActions::add(const char* detector, int64_t key, const std::string& what, const std::string& mend,
                          const Moment& moment) {
  keys_.push_back({detector, key});
  found_.push_back({detector, what, mend, moment.where, seconds(moment.t), 1});
}

void DoubtfulActions::acted(const FirmwareAction& action, SimTime t, const Where& where) {
  const auto& [first, second, third] = action.argument;
  switch (action.kind) {
    case FirmwareAction::Kind::analog_write:
      return wrote(first, second, t, where);
    case FirmwareAction::Kind::attach_interrupt:
      return attached(first, t, where);
    case FirmwareAction::Kind::delay:
      return delayed(first, t, where);
    case FirmwareAction::Kind::timer_mode:
      return changed_mode(first, second != 0, third != 0, t, where);
    case FirmwareAction::Kind::compare_write:
      for (TakenTimer& taken : timers_)
        if (taken.timer == first && !taken.wrote) taken.wrote = {t, where()};
      return;
    case FirmwareAction::Kind::missing_pin:
      return used_missing(first, kPinFunctions[second], t, where);
    case FirmwareAction::Kind::conversion:
      return slow_source_.converted(static_cast<Pin>(first), 1e-9 * static_cast<double>(second), t, where);
  }
}

void DoubtfulActions::used_missing(int64_t number, const char* function, SimTime t, const Where& where) {
  const bool is_pin = number < board_->pin_count;
  if (is_pin && board_->pins[number].digital) return;
  if (add_occurrence("missing_pin", number)) return;
  add(result::detector("missing_pin"), number,
      is_pin ? fmt::format("{}() got pin {}, which can only be read with analogRead(); it was called",
                           function, board_->pins[number].name)
             : fmt::format("{}() got pin {}, which the {} does not have; it was called", function, number,
                           board_->name),
      is_pin ? "Use a digital pin."
             : "If the number comes from an array, check its index. On an AVR, such a call reads and changes "
               "random registers.",
      {t, where()});
}

void DoubtfulActions::wrote(int64_t number, int64_t value, SimTime t, const Where& where) {
  if (number >= board_->pin_count || !board_->pins[number].digital) return;
  const PinSpec& pin = board_->pins[number];
  if (value < 0 || value > kHighest) {
    if (add_occurrence("pwm_range", number)) return;
    const int effect = pin.pwm       ? pwm_effect(*board_, static_cast<Pin>(number), value)
                       : value < 128 ? 0
                                     : kHighest;
    add(result::detector("pwm_range"), number,
        fmt::format(
            "analogWrite({}, {}) acted like analogWrite({}, {}), since it takes 0 to 255; it was called",
            number, value, number, effect),
        value < 0
            ? "A sign has no effect here: write abs(value), and set the direction by the driver's other "
              "pins; or limit the value: constrain(value, 0, 255)."
            : "Limit the value: constrain(value, 0, 255).",
        {t, where()});
    return;
  }
  if (pin.pwm || value == 0 || value == kHighest || add_occurrence("lost_pwm", number)) return;
  add(result::detector("lost_pwm"), number,
      fmt::format("pin {} of the {} has no PWM, and is LOW for values below 128, and HIGH otherwise: "
                  "analogWrite({}, {})",
                  name_of(*board_, static_cast<Pin>(number)), board_->name, number, value),
      fmt::format("Use a pin with PWM: {}.", pwm_pins(*board_)), {t, where()});
}

void DoubtfulActions::attached(int64_t number, SimTime t, const Where& where) {
  const bool has_number = std::any_of(board_->pins, board_->pins + board_->pin_count,
                                      [&](const PinSpec& pin) { return pin.interrupt == number; });
  if (has_number || (number < board_->chip->external_count && !board_->host_model)) return;
  if (add_occurrence("no_interrupt", number)) return;
  const bool is_pin = number < board_->pin_count && board_->pins[number].interrupt >= 0;
  const std::string got =
      number == kNoInterrupt
          ? "255, which digitalPinToInterrupt() returns for a pin without an external interrupt"
      : is_pin
          ? fmt::format("{}, which is a pin: its interrupt is {}", number, board_->pins[number].interrupt)
          : fmt::format("{}, which the {} does not have", number, board_->name);
  add(result::detector("no_interrupt"), number,
      fmt::format("attachInterrupt() had no effect, since it got the interrupt number {}; it was called",
                  got),
      is_pin ? fmt::format("For pin {}, write attachInterrupt(digitalPinToInterrupt({}), …).", number, number)
             : fmt::format("Use a pin with an external interrupt, {}, and write digitalPinToInterrupt(pin).",
                           pins_of(*board_, " or ", [](const PinSpec& pin) { return pin.interrupt >= 0; })),
      {t, where()});
}

void DoubtfulActions::delayed(int64_t ms, SimTime t, const Where& where) {
  if (ms >> 31 == 0 || add_occurrence("long_delay", ms)) return;
  add(result::detector("long_delay"), ms,
      fmt::format("delay({}) lasts {:.0f} days; its number may have been negative, {}; it was called", ms,
                  static_cast<double>(ms) / kMsPerDay, static_cast<int32_t>(ms)),
      "Compute the time as unsigned long, for example 4UL * 10000, and subtract only smaller times.",
      {t, where()});
}

void DoubtfulActions::changed_mode(int64_t timer, bool makes_pwm, bool had_pwm, SimTime t,
                                   const Where& where) {
  if (!is_avr(*board_)) return;  // a sketch for another chip writes no registers of an AVR's timers
  const auto taken =
      std::find_if(timers_.begin(), timers_.end(), [&](const TakenTimer& one) { return one.timer == timer; });
  if (taken != timers_.end()) {
    if (const auto seen = told(*taken, t); seen && !add_occurrence("lost_pwm", key_of(timer))) {
      keys_.push_back({"lost_pwm", key_of(timer)});
      found_.push_back(*seen);
    }
    timers_.erase(taken);
  }
  if (!makes_pwm) timers_.push_back({timer, {t, where()}, std::nullopt, had_pwm});
}

std::optional<exec::Detected> DoubtfulActions::told(const TakenTimer& taken, SimTime now) const {
  if (!taken.wrote && !taken.had_pwm) return std::nullopt;
  const Moment& moment = taken.wrote ? *taken.wrote : taken.taken;
  if (now - moment.t < kSetUp) return std::nullopt;
  const auto timer_of = [&](const PinSpec& pin) {
    return pin.pwm && pin.chip_pin.timer >= 0 ? board_->chip->timers[pin.chip_pin.timer].number : -1;
  };
  const auto is_its = [&](const PinSpec& pin) { return timer_of(pin) == taken.timer; };
  const auto is_others = [&](const PinSpec& pin) { return timer_of(pin) >= 0 && !is_its(pin); };
  const std::string pins = pins_of(*board_, " and ", is_its), others = pins_of(*board_, " or ", is_others);
  if (pins.empty()) return std::nullopt;
  const bool one = pins.find(' ') == pins.npos;
  const std::string subject = fmt::format("pin{} {}", one ? "" : "s", pins);
  return exec::Detected{
      result::detector("lost_pwm"),
      taken.wrote
          ? fmt::format("{} had no PWM, since {} timer {} had left its PWM mode{} ({:.2f} s); a duty cycle "
                        "was written",
                        subject, one ? "its" : "their", taken.timer, place_of(taken.taken.where),
                        seconds(taken.taken.t))
          : fmt::format("{} lost the PWM, since {} timer {} left its PWM mode", subject,
                        one ? "its" : "their", taken.timer),
      fmt::format("Use pins whose PWM comes from another timer{}, or a library that needs another timer.",
                  others.empty() ? "" : " (" + others + ")"),
      moment.where,
      seconds(moment.t),
      1};
}

std::vector<exec::Detected> DoubtfulActions::found(SimTime now) const {
  std::vector<exec::Detected> all = found_;
  for (const TakenTimer& taken : timers_) {
    const bool is_old = std::any_of(keys_.begin(), keys_.end(),
                                    [&](const Key& key) { return key.argument == key_of(taken.timer); });
    if (const auto seen = told(taken, now); seen && !is_old) all.push_back(*seen);
  }
  for (exec::Detected& one : slow_source_.found()) all.push_back(std::move(one));
  return all;
}

DoubtfulActionsOnHost::DoubtfulActionsOnHost(exec::Executor& executor, SnapshotRegistry& snapshots)
    : executor_(executor), state_{DoubtfulActions(executor.board().spec())} {
  if (exec::HostAccess* const host = executor.host_access()) host->watch_actions(*this);
  snapshots.add(state_);
}

void DoubtfulActionsOnHost::acted(const FirmwareAction& action, SimTime t) {
  state_.actions.acted(action, t, [&] { return executor_.sketch_source(); });
}

}  // namespace robosim::detect
