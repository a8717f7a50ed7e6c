// Finds the decisive moment of a run, from which `robosim why` starts.
#include <fmt/format.h>

#include "sim/judge/explain.h"

namespace robosim::judge {

Decisive decisive_moment(const Evidence& e) {
  const auto& seen = e.judge->line_last_seen();
  Decisive leaves_line{seen ? seen->at : 0, "the robot left the line", true, false};
  switch (e.verdict) {
    case Verdict::lost:
      return seen ? leaves_line
                  : Decisive{e.t, "the robot drove, but no sensor had seen a line", true, false};
    case Verdict::stuck:
      if (left_line_before(e, e.judge->stuck_since())) return leaves_line;
      return {e.judge->stuck_since(),
              e.judge->pushes() ? "from here on it pushed against " + e.stopped_by
              : e.in_contact
                  ? fmt::format("from here on its motors were driven, but it only touched {}", e.stopped_by)
                  : "its motors were driven from here on, but it did not move",
              true, false};
    case Verdict::toppled:
      return {e.t, "the robot toppled", true, false};
    case Verdict::crashed:
      return {e.t, "the sketch crashed", false, true};
    case Verdict::hung:
    case Verdict::ended:
      return {e.t,
              e.activity.stopped_by.empty() ? "the sketch loops here and calls no functions any more"
                                            : "the sketch stopped itself here",
              false, true};
    case Verdict::timeout:
      if (!e.power.on && !(left_line_before(e, e.t) && seen->at < e.power.since))
        return {e.power.since, "the board lost its power", true, false};
      if (e.moved && !e.judge->drives(e.t)) leaves_line.off_since = e.judge->last_driven();
      if (left_line_before(e, e.t)) return leaves_line;
      if (!e.moved) return {e.t, "the robot has not moved, and the sketch was here", true, true, e.t};
      if (!e.judge->drives(e.t))
        return {e.judge->last_driven(), kMotorsStayOff, true, true, e.judge->last_driven()};
      if (spins(e))
        return {e.judge->turns_since(e.judge->place()), "the robot spins from here on", true, false};
      if (e.t - e.judge->drives_here_since() >= kInOnePlaceAfter)
        return {e.judge->drives_here_since(),
                "the robot stayed in one place from here on, with its motors driven", true, false};
      return {e.t,
              e.t - e.judge->last_driven() <= kTick
                  ? "the robot was still driving when its time was up"
                  : "the robot's motors were driven until less than a second before its time was up",
              true, false};
    case Verdict::reached:
      if (const auto& left = e.judge->line_first_left(); left && was_off_line(e))
        return {left->at, "the robot left the line for the first time", true, false};
      break;
    case Verdict::over_budget:
    case Verdict::interrupted:
      break;
  }
  return {};
}

}  // namespace robosim::judge
