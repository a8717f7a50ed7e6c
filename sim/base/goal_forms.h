// The goals that a run may have, as users write them: in maps, scripts, checks and on command lines.
#pragma once

#include <initializer_list>
#include <string>

namespace robosim {

/// All goals. A capital after a colon stands for the goal's parameter.
inline constexpr std::initializer_list<const char*> kGoalForms = {
    "tour",        "laps:N",    "station:NAME", "robotrace", "ukmars", "drag-race",
    "rescue-line", "line-maze", "line-maze:N",  "still",     "none"};

/// The most tries that line-maze:N may allow.
inline constexpr int kMostMazeTries = 3;

/// Returns what is wrong with a goal that is not valid: "expected tour, laps:N, ... or none, got “lap:3”; did
/// you mean laps:3?".
std::string expected_goal(const std::string& goal);

}  // namespace robosim
