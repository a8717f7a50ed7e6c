#include "sim/judge/supply_summary.h"

#include <fmt/format.h>

namespace robosim::judge {

std::string told(const SupplySummary& power) {
  const double since = 1e-9 * static_cast<double>(power.since);
  if (!power.on) {
    const std::string text = fmt::format("the board has had no power since {:.2f} s", since);
    if (!power.switched_on) return text + ": the script switched it off";
    if (power.empty()) return text + ": its battery is empty";
    if (power.charge)
      return fmt::format(
          "{}: its battery, at {:.0f} % of its charge, gives {:.2f} V of the required {:.2f} V", text,
          100.0 * *power.charge, power.volts, power.needed);
    return text;
  }
  if (power.empty()) return "its battery is empty";
  if (power.resets == 0) return "";
  return fmt::format(
      "the chip was reset {}, {} at {:.2f} s",
      power.resets == 1 ? "once by a brown-out" : fmt::format("{} times by brown-outs", power.resets),
      power.resets == 1 ? "and ran again" : "and last ran again",
      1e-9 * static_cast<double>(power.recovered));
}

}  // namespace robosim::judge
