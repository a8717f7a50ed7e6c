#include "sim/judge/wiring_usage.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::judge {
namespace {

// Noise changes a reading by less than this share of the supply voltage; a line under the sensor changes it
// by more.
constexpr double kSteady = 0.1;  // share of the supply

/// A part, or an element of an array.
struct Unit {
  std::string name;
  std::vector<Pin> pins;
  bool reports;  ///< firmware reads the part
  bool obeys;    ///< firmware drives the part, and does not read it
};

bool reports(const std::string& type) {
  return type == "button" || type == "bumper" || type == "reflectance-array";
}

bool obeys(const std::string& type) {
  return type == "motor" || type == "led" || type == "buzzer" || type == "servo" || type == "stepper";
}

std::vector<Unit> units_of(const std::vector<robot::WiredPin>& wiring) {
  std::vector<Unit> units;
  for (const robot::WiredPin& wired : wiring) {
    const bool is_element = wired.type == "reflectance-array" && wired.role.rfind("emitter", 0) != 0;
    const std::string& name = is_element ? wired.role : wired.part;
    const auto known =
        std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
    if (known != units.end()) {
      known->pins.push_back(wired.pin);
    } else {
      const bool is_read = reports(wired.type) && (is_element || wired.type != "reflectance-array");
      units.push_back({name, {wired.pin}, is_read, obeys(wired.type)});
    }
  }
  return units;
}

// Returns whether the board's serial line may have used the pin.
bool is_of_uart(const BoardSpec& board, Pin pin) { return pin < 2 && board.analog_pin_0 > 2; }

// Returns whether the firmware has read the pin on purpose. An awaited edge does not count if a timer can
// capture the pin's edges without the firmware.
bool is_read_on_purpose(const BoardSpec& board, Pin pin, const exec::PinUse& use) {
  return use.looked_at || use.measured || (use.awaited && !can_capture(board, pin)) ||
         (use.read && use.pulled_up);
}

std::string steady_reading(const BoardSpec& board, const exec::PinUse& use, SimTime now) {
  constexpr SimTime kStoppedFor = kSecond;
  std::string reading;
  if (use.measured) {
    if (use.highest_volts - use.lowest_volts >= kSteady * board.supply_volts) return "";
    reading = fmt::format("{:.1f} V", (use.lowest_volts + use.highest_volts) / 2.0);
  } else {
    if (!use.read || use.was_low == use.was_high) return "";
    reading = use.was_high ? "HIGH" : "LOW";
  }
  if (!use.awaited && now - use.last_seen >= kStoppedFor)
    reading += fmt::format(", last read at {:.2f} s", 1e-9 * static_cast<double>(use.last_seen));
  return reading;
}

}  // namespace

result::Usage usage_of(const BoardSpec& board, const std::vector<robot::WiredPin>& wiring,
                       const std::vector<bool>& was_output, const exec::BoardProbe& probe, SimTime now) {
  result::Usage usage;
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    const bool wired =
        std::any_of(wiring.begin(), wiring.end(), [&](const auto& wire) { return wire.pin == pin; });
    if (wired || pin == board.led_builtin || is_of_uart(board, pin)) continue;
    const exec::PinUse& use = probe.use(pin);
    if (!was_output[pin] && !is_read_on_purpose(board, pin, use)) continue;
    usage.unwired.push_back({board.pins[pin].name, was_output[pin] ? "driven" : "read"});
  }
  for (const Unit& unit : units_of(wiring)) {
    const auto is_used = [&](Pin pin) {
      if (pin >= board.pin_count || is_of_uart(board, pin)) return true;
      const exec::PinUse& use = probe.use(pin);
      return was_output[pin] || (!unit.obeys && (use.read || use.measured || use.awaited));
    };
    if (std::none_of(unit.pins.begin(), unit.pins.end(), is_used)) {
      usage.unused.push_back(unit.name);
    } else if (unit.reports && unit.pins.size() == 1 && unit.pins[0] < board.pin_count) {
      const std::string reading = steady_reading(board, probe.use(unit.pins[0]), now);
      if (!reading.empty()) usage.steady.push_back({unit.name, reading});
    }
  }
  return usage;
}

}  // namespace robosim::judge
