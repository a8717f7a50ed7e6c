#include "sim/campaign/random_worlds/fault_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::random_worlds {
namespace {

double badness(const Fault& fault) { return static_cast<double>(fault.level) / Fault::kLevels; }

std::string deed(const Fault& fault, const FaultLimits& limits) {
  const double sign = fault.negative ? -1.0 : 1.0;
  switch (fault.kind) {
    case Fault::Kind::offset:
      return fmt::format("fault {} offset {:.4g}", fault.part, sign * badness(fault) * limits.sensor_offset);
    case Fault::Kind::noisy:
      return fmt::format("fault {} noisy {:.4g}", fault.part, badness(fault) * limits.sensor_noise);
    case Fault::Kind::cover:
      return fmt::format("cover {} for {}us", fault.part, limits.covered_us * fault.level / Fault::kLevels);
    case Fault::Kind::weak:
      return fmt::format("fault {} weak {:.4g}", fault.part, 1.0 - badness(fault) * limits.motor_weakness);
    case Fault::Kind::drift:
      return fmt::format("fault clock drift {:.0f}ppm", sign * badness(fault) * limits.clock_drift_ppm);
  }
  return "";
}

}  // namespace

std::vector<FaultPlan> FaultPlan::smaller() const {
  std::vector<FaultPlan> found;
  if (faults.size() > 1) found.emplace_back();
  for (std::size_t i = 0; i < faults.size(); ++i) {
    found.push_back(*this);
    found.back().faults.erase(found.back().faults.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const auto change = [&](std::size_t i, int Fault::*what, int to) {
    if (faults[i].*what <= to) return;
    found.push_back(*this);
    found.back().faults[i].*what = to;
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    for (const int level : {1, faults[i].level / 2, faults[i].level - 1})
      if (level > 0) change(i, &Fault::level, level);
    change(i, &Fault::at_ms, 0);
    change(i, &Fault::at_ms, faults[i].at_ms / 1000 * 1000);
  }
  return found;
}

std::string FaultPlan::script(const FaultLimits& limits) const {
  std::string text;
  for (const Fault& fault : faults) text += fmt::format("at {}ms {}\n", fault.at_ms, deed(fault, limits));
  return text;
}

FaultPlan draw_up(const FaultLimits& limits, int most, const Breakable& parts, const RandomSource& rng) {
  std::vector<Fault> kinds;
  const auto add = [&](bool may, Fault::Kind kind, const std::vector<std::string>& names) {
    if (!may) return;
    for (const std::string& part : names) kinds.push_back({kind, part});
  };
  add(limits.sensor_offset > 0.0, Fault::Kind::offset, parts.sensors);
  add(limits.sensor_noise > 0.0, Fault::Kind::noisy, parts.sensors);
  add(limits.covered_us > 0, Fault::Kind::cover, parts.sensors);
  add(limits.motor_weakness > 0.0, Fault::Kind::weak, parts.motors);
  add(limits.clock_drift_ppm > 0.0, Fault::Kind::drift, {""});
  FaultPlan plan;
  if (kinds.empty()) return plan;
  const int span_ms = limits.until_ms - limits.from_ms;
  for (int left = rng(most + 1); left > 0; --left) {
    Fault fault = kinds[static_cast<std::size_t>(rng(static_cast<int>(kinds.size())))];
    fault.at_ms = limits.from_ms + rng(std::max(1, span_ms));
    fault.level = 1 + rng(Fault::kLevels);
    fault.negative = rng(2) == 1;
    plan.faults.push_back(fault);
  }
  std::stable_sort(plan.faults.begin(), plan.faults.end(),
                   [](const Fault& a, const Fault& b) { return a.at_ms < b.at_ms; });
  return plan;
}

}  // namespace robosim::random_worlds
