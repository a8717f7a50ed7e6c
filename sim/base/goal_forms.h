// Lists the goals of runs, in the form that users write in maps, scripts, checks and on command lines.
#pragma once

#include <initializer_list>
#include <string>

namespace robosim {

/// All goals. After a colon, N or NAME stands for the goal's parameter.
inline constexpr std::initializer_list<const char*> kGoalForms = {
    "tour",        "laps:N",    "station:NAME", "robotrace", "ukmars", "drag-race",
    "rescue-line", "line-maze", "line-maze:N",  "still",     "none"};

/// Largest number of tries in line-maze:N.
inline constexpr int kMostMazeTries = 3;

/// Returns the error text for an invalid goal: "expected tour, laps:N, ... or none, got “lap:3”; did you
/// mean laps:3?".
std::string expected_goal(const std::string& goal);

}  // namespace robosim
