#include "sim/base/goal_forms.h"

#include <fmt/format.h>

#include "sim/base/did_you_mean.h"

namespace robosim {

std::string expected_goal(const std::string& goal) {
  if (goal.starts_with("laps:")) return fmt::format("expected laps:N with N from 1, got “{}”", goal);
  if (goal.starts_with("line-maze:"))
    return fmt::format("expected line-maze:N with N from 1 to {} tries, got “{}”", kMostMazeTries, goal);
  if (goal == "station:") return "expected station:NAME with a station's number or name, got “station:”";
  return expected_one_of(goal, {kGoalForms.begin(), kGoalForms.end()});
}

}  // namespace robosim
