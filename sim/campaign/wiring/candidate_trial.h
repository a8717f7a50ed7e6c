// Tries out a draft of a robot with its sketch. The sketch's use of its pins refines the next draft. If
// several wirings are possible, chooses a wiring with which the robot follows a line.
#pragma once

#include <filesystem>
#include <string>

#include "sim/campaign/wiring/draft.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"

namespace robosim::wiring {

/// Returns whether the robot has followed the line for a lap. Excludes laps by luck, in which the RMS
/// cross-track error is at least 50 mm. Also excludes laps in which the sensors are off the line half of the
/// time. The second condition does not apply to `sensors_beside`: sensors that are next to the line and
/// rarely see the line.
bool follows_a_lap(const result::RunResult& result, bool sensors_beside);

class CandidateTrial {
 public:
  /// `launch` has no robot. Scratch files go into `folder`.
  CandidateTrial(launch::Launch launch, const BoardSpec& board, const std::filesystem::path& folder,
                 launch::Listener listener);

  /// Makes drafts until a run shows nothing new, but at most five. Throws InputError if the sketch does not
  /// build.
  RobotDraft draft();
  /// Tries the variants that `draft` leaves open, until one follows the line for a lap. Sets `draft` to the
  /// variant that drives best. Returns the result of its run.
  result::RunResult choose(RobotDraft& draft);
  /// Return the number of variants that choose() has tried, and whether the chosen variant follows the line
  /// for a lap.
  int tried() const { return tried_; }
  bool follows() const { return follows_; }

 private:
  /// Guesses a draft. Parts that the reader of robot files refuses become questions.
  RobotDraft guess(const Ways& ways);
  result::RunResult run(const RobotDraft& draft, double for_s, const std::string& goal, PinHistory* history);

  launch::Launch launch_;
  const BoardSpec& board_;
  std::filesystem::path file_;
  launch::Launcher launcher_;
  client::Runner runner_;
  SketchNames names_;
  PinHistory history_;
  int tried_ = 0;
  bool follows_ = false;
};

}  // namespace robosim::wiring
